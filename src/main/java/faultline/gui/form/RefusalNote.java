package faultline.gui.form;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import javax.swing.JComponent;
import javax.swing.JToolTip;
import javax.swing.Popup;
import javax.swing.PopupFactory;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.event.AncestorEvent;
import javax.swing.event.AncestorListener;

/**
 * A note below a field, or below what hides it, that says why its text is refused. Screen readers get it as the
 * description of the field.
 */
public final class RefusalNote {

    private static final int MIN_MILLIS = 4000;
    private static final int MILLIS_PER_CHARACTER = 80;
    private static final int GAP = 2;

    private final JComponent field;
    private final Timer end = new Timer(MIN_MILLIS, event -> hide());
    /** Null while nothing is shown. */
    private Popup popup;

    /** The number of sentences shown so far; the same popup may show several. */
    private int opened;

    private String text = "";

    /** Creates the note of a field, not yet visible. */
    public RefusalNote(JComponent field) {
        this.field = field;
        end.setRepeats(false);
        field.addAncestorListener(new AncestorListener() {
            @Override
            public void ancestorAdded(AncestorEvent event) {
                // Nothing to do.
            }

            @Override
            public void ancestorRemoved(AncestorEvent event) {
                // Not now, because a window that is disposed removes its components, which may include the note.
                int shown = opened;
                EventQueue.invokeLater(() -> {
                    if (opened == shown) {
                        hide();
                    }
                });
            }

            @Override
            public void ancestorMoved(AncestorEvent event) {
                hide();
            }
        });
    }

    /** Shows a sentence until it is hidden. */
    void show(String sentence) {
        end.stop();
        if (!sentence.equals(text)) {
            hide();
            open(sentence);
        }
    }

    /** Shows a sentence for as long as it takes to read. */
    public void showBriefly(String sentence) {
        show(sentence);
        end.setInitialDelay(Math.max(MIN_MILLIS, MILLIS_PER_CHARACTER * sentence.length()));
        end.restart();
    }

    private void open(String sentence) {
        Component place = place();
        if (place == null) {
            return;
        }
        opened++;
        text = sentence;
        field.getAccessibleContext().setAccessibleDescription(sentence);
        JToolTip tip = field.createToolTip();
        tip.setTipText(sentence);
        Point at = location(place, tip.getPreferredSize());
        popup = PopupFactory.getSharedInstance().getPopup(place, tip, at.x, at.y);
        popup.show();
    }

    /** Returns the field, or the nearest container that is shown, such as the tabs around it; null if none is. */
    private Component place() {
        Component place = field;
        while (place != null && !place.isShowing()) {
            place = place.getParent();
        }
        return place;
    }

    /**
     * Returns the location below a component, or above it at the bottom of the window or where the note would cover
     * another field that has the focus, within the width of the window.
     */
    private static Point location(Component place, Dimension size) {
        Window window = SwingUtilities.getWindowAncestor(place);
        Rectangle bounds = window.getBounds();
        Point origin = place.getLocationOnScreen();
        int x = Math.max(bounds.x, Math.min(origin.x, bounds.x + bounds.width - window.getInsets().right - size.width));
        int below = origin.y + place.getHeight() + GAP;
        boolean room = below + size.height <= bounds.y + bounds.height - window.getInsets().bottom
                && !coversFocus(place, new Rectangle(new Point(x, below), size));
        return new Point(x, room ? below : origin.y - size.height - GAP);
    }

    private static boolean coversFocus(Component place, Rectangle note) {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return focused instanceof JComponent next
                && next.isShowing()
                && !SwingUtilities.isDescendingFrom(next, place)
                && note.intersects(new Rectangle(
                        next.getLocationOnScreen(), next.getVisibleRect().getSize()));
    }

    /** Hides the sentence, if one is shown. */
    public void hide() {
        end.stop();
        if (popup != null) {
            popup.hide();
            popup = null;
            text = "";
            field.getAccessibleContext().setAccessibleDescription(null);
        }
    }
}
