package faultline.gui.dialog;

import faultline.gui.action.Notes;
import faultline.gui.text.Messages;
import faultline.io.MessageText;
import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/**
 * Shows the newest line that a controller writes to its standard error, and keeps the newest lines for the event log. A
 * line of a controller of the run that has been replaced is removed, and a later one is not shown. The lines of a ghost
 * do not depend on the run.
 */
final class ErrorLines {

    private static final int NEVER_REPLACED = Integer.MAX_VALUE;

    /** The length of a line that has room in a tool tip, characters. */
    private static final int MAX_LENGTH = 400;

    /** The maximum number of lines that wait for the event log, so that a flood of lines does not fill the memory. */
    static final int MAX_WAITING = 300;

    private record ErrorLine(int controller, String text) {}

    private final Notes notes;
    /** The newest line that is not shown yet. */
    private final AtomicReference<ErrorLine> unshown = new AtomicReference<>();

    /** The newest lines that have not been taken, the oldest first; guarded by itself. */
    private final Deque<ErrorLine> waiting = new ArrayDeque<>();

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
        synchronized (waiting) {
            if (waiting.size() == MAX_WAITING) {
                waiting.removeFirst();
            }
            waiting.addLast(line);
        }
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

    /**
     * Returns the lines of the driving controller and of ghosts since the last call. Those of a controller that is
     * being started wait until it drives.
     */
    List<String> takeNew() {
        assert EventQueue.isDispatchThread();
        List<String> taken = new ArrayList<>();
        synchronized (waiting) {
            for (Iterator<ErrorLine> lines = waiting.iterator(); lines.hasNext(); ) {
                ErrorLine line = lines.next();
                boolean ghost = line.controller() == NEVER_REPLACED;
                if (ghost || line.controller() == driving) {
                    taken.add(ghost ? Messages.get("event.ghostOutput", line.text()) : line.text());
                }
                if (ghost || line.controller() <= driving) {
                    lines.remove();
                }
            }
        }
        return taken;
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
