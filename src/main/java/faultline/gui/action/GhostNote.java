package faultline.gui.action;

import faultline.gui.document.ComparisonController;
import faultline.gui.document.ComparisonController.PendingReference;
import faultline.gui.text.Messages;
import faultline.io.MessageText;
import java.util.function.LongSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Keeps a note about the progress of a reference run that takes longer than half a second. */
final class GhostNote {

    private static final long NANOS_BEFORE_NOTE = 500_000_000;
    private static final int PERCENT = 100;
    private static final int MAX_NAME_LENGTH = 14;

    private static final Pattern FILE_NAME = Pattern.compile("[^\\s\"/\\\\]+\\.\\p{Alpha}\\w*");
    private static final Pattern FOLDER = Pattern.compile("^\\S*[/\\\\]");

    private final ComparisonController controller;
    private final Notes notes;
    private final LongSupplier nanoTime;
    /** Null if no reference run is being made. */
    private PendingReference pending;
    /** The time at which the pending run was seen first. */
    private long since;

    private String shown = "";

    GhostNote(ComparisonController controller, Notes notes, LongSupplier nanoTime) {
        this.controller = controller;
        this.notes = notes;
        this.nanoTime = nanoTime;
    }

    /** Updates the note; called many times per second while a reference run is being made. */
    void update() {
        long now = nanoTime.getAsLong();
        if (controller.pending().orElse(null) != pending) {
            pending = controller.pending().orElse(null);
            since = now;
        }
        String text = pending != null && now - since > NANOS_BEFORE_NOTE ? format(pending) : "";
        if (text.equals(shown)) {
            return;
        }
        notes.remove(shown);
        if (!text.isEmpty()) {
            notes.keep(text);
        }
        shown = text;
    }

    private static String format(PendingReference pending) {
        int percent = (int) (PERCENT * pending.progress().fraction().orElse(0));
        return Messages.get("ghost.progress", Integer.toString(percent), shortName(pending.name()));
    }

    /**
     * Returns a name or command that leaves room for the state of the run. Of a long command, it is the first name of a
     * file, such as that of a Python program, or the command without its folder.
     */
    static String shortName(String name) {
        if (name.length() <= MAX_NAME_LENGTH) {
            return name;
        }
        Matcher file = FILE_NAME.matcher(name);
        return start(file.find() ? file.group() : FOLDER.matcher(name).replaceFirst(""));
    }

    private static String start(String name) {
        return name.length() <= MAX_NAME_LENGTH ? name : MessageText.start(name, MAX_NAME_LENGTH - 1) + "…";
    }
}
