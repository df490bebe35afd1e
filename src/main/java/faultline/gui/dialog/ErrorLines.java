package faultline.gui.dialog;

import faultline.gui.action.Notes;
import faultline.io.MessageText;
import java.awt.EventQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * Shows the newest line that a controller writes to its standard error. A line of a controller of the run that has been
 * replaced is removed, and a later one is not shown. The lines of a ghost do not depend on the run.
 */
final class ErrorLines {

    private static final int NEVER_REPLACED = Integer.MAX_VALUE;

    /** The length of a line that has room in a tool tip, characters. */
    private static final int MAX_LENGTH = 400;

    private record ErrorLine(int controller, String text) {}

    private final Notes notes;
    /** The newest line that is not shown yet. */
    private final AtomicReference<ErrorLine> unshown = new AtomicReference<>();

    private final AtomicInteger created = new AtomicInteger();
    private int driving;
    private ErrorLine shown = new ErrorLine(NEVER_REPLACED, "");

    ErrorLines(Notes notes) {
        this.notes = notes;
    }

    /** Returns the receiver of the lines of a new controller of the run. Any thread may call both. */
    Consumer<String> forNewController() {
        int controller = created.incrementAndGet();
        return text -> add(controller, text);
    }

    /** Returns the receiver of the lines of a ghost's controller. Any thread may call it. */
    Consumer<String> forGhost() {
        return text -> add(NEVER_REPLACED, text);
    }

    /** Shows the newest line only, because lines may arrive faster than they can be shown. */
    private void add(int controller, String text) {
        ErrorLine line = new ErrorLine(controller, MessageText.shortened(text, MAX_LENGTH));
        if (unshown.getAndAccumulate(line, this::newest) == null) {
            EventQueue.invokeLater(this::showNewest);
        }
    }

    /** Returns an added line, or the old one if the added one is of a controller that has been replaced since. */
    private ErrorLine newest(ErrorLine oldOrNull, ErrorLine added) {
        return oldOrNull != null && added.controller() < Math.min(oldOrNull.controller(), created.get())
                ? oldOrNull
                : added;
    }

    private void showNewest() {
        ErrorLine line = unshown.getAndSet(null);
        if (line.controller() >= driving) {
            shown = line;
            notes.showLine(line.text());
        }
    }

    /** Lets the newest controller replace the earlier ones. */
    void controllerStarted() {
        assert EventQueue.isDispatchThread();
        driving = created.get();
        if (shown.controller() < driving) {
            notes.remove(shown.text());
        }
    }
}
