package faultline.gui.window;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import javax.swing.KeyStroke;
import javax.swing.LayoutFocusTraversalPolicy;
import javax.swing.SwingUtilities;

/** The areas of the window among which F6 and Shift+F6 move the focus. */
final class FocusAreas {

    private final List<Container> areas;
    /** The area that has been requested and does not have the focus yet, null for none. */
    private Container pending;

    /** Creates the areas in the order of F6; those that are not showing are omitted when the focus moves. */
    FocusAreas(List<Container> areas) {
        this.areas = List.copyOf(areas);
    }

    /** Adds the actions of F6 and Shift+F6; {@code mover} receives the number of areas to move by. */
    static void addActions(ActionRegistry actions, IntConsumer mover) {
        actions.add(
                UiAction.of("nextArea", () -> mover.accept(1)).withAccelerator(Keystrokes.unmodified(KeyEvent.VK_F6)));
        actions.add(UiAction.of("previousArea", () -> mover.accept(-1))
                .withAccelerator(KeyStroke.getKeyStroke(KeyEvent.VK_F6, InputEvent.SHIFT_DOWN_MASK)));
    }

    /**
     * Moves the focus by a number of areas. The focus arrives later than the call returns: a second call before that
     * counts from the area that the first one has chosen.
     */
    void move(int step) {
        List<Container> shown = areas.stream().filter(Component::isShowing).toList();
        if (!shown.isEmpty()) {
            int current = pending == null ? focused(shown) : shown.indexOf(pending);
            int from = current < 0 && step < 0 ? 0 : current;
            focus(shown.get(Math.floorMod(from + step, shown.size())));
        }
    }

    private static int focused(List<Container> shown) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return IntStream.range(0, shown.size())
                .filter(i -> owner != null && SwingUtilities.isDescendingFrom(owner, shown.get(i)))
                .findFirst()
                .orElse(-1);
    }

    private void focus(Container area) {
        Component first = area instanceof SimulationCanvas || area.getComponentCount() == 0
                ? area
                : new LayoutFocusTraversalPolicy().getFirstComponent(area);
        pending = null;
        if (first != null && !first.isFocusOwner()) {
            pending = area;
            first.addFocusListener(new FocusAdapter() {
                @Override
                public void focusGained(FocusEvent event) {
                    first.removeFocusListener(this);
                    pending = null;
                }
            });
            first.requestFocusInWindow(FocusEvent.Cause.TRAVERSAL);
        }
    }
}
