package faultline.gui.action;

import faultline.gui.document.ComparisonController;
import faultline.gui.document.ComparisonController.PendingReference;
import faultline.gui.text.Messages;

/** Keeps a note about the progress of a reference run that takes longer than half a second. */
final class GhostNote {

    /** Half a second at sixty polls per second. */
    private static final int POLLS_BEFORE_NOTE = 30;

    private static final int PERCENT = 100;

    private final ComparisonController controller;
    private final Notes notes;
    private int polls;
    private String shown = "";

    GhostNote(ComparisonController controller, Notes notes) {
        this.controller = controller;
        this.notes = notes;
    }

    /** Updates the note; called about sixty times per second while a reference run is being made. */
    void update() {
        polls = controller.isLoading() ? polls + 1 : 0;
        String text = polls > POLLS_BEFORE_NOTE
                ? controller.pending().map(GhostNote::format).orElse("")
                : "";
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
        return Messages.get("ghost.progress", Integer.toString(percent), pending.name());
    }
}
