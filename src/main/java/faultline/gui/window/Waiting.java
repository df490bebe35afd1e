package faultline.gui.window;

import faultline.gui.document.UnderWay;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.Optional;
import java.util.stream.Stream;

/** Shows what is under way once it has taken long enough for a user to wonder, and lets it be given up. */
final class Waiting {

    /** At sixty looks in a second, half a second. */
    private static final int PATIENCE = 30;

    private final Window owner;
    private final Runnable cancel;
    private Optional<UnderWay> waitedFor = Optional.empty();
    private Optional<WaitDialog> dialog = Optional.empty();
    private int looks;

    Waiting(Window owner, Runnable cancel) {
        this.owner = owner;
        this.cancel = cancel;
    }

    /** Shows how it stands; asked some sixty times in a second. */
    void show(Optional<UnderWay> now) {
        if (!now.equals(waitedFor)) {
            end();
            waitedFor = now;
        }
        now.ifPresent(this::show);
    }

    private void show(UnderWay way) {
        looks += isAsking() ? 0 : 1;
        dialog.ifPresent(shown -> shown.show(way.share()));
        if (looks == PATIENCE) {
            WaitDialog made = new WaitDialog(owner, way, cancel);
            dialog = Optional.of(made);
            // Not at once: whoever looks here must be able to look again while the dialog is open.
            EventQueue.invokeLater(() -> dialog.filter(shown -> shown == made).ifPresent(shown -> shown.setVisible(true)));
        }
    }

    /** Whether another question is open: one at a time. */
    private boolean isAsking() {
        return dialog.isEmpty() && Stream.of(owner.getOwnedWindows()).anyMatch(window -> window instanceof Dialog && window.isShowing());
    }

    private void end() {
        dialog.ifPresent(Window::dispose);
        dialog = Optional.empty();
        looks = 0;
    }
}
