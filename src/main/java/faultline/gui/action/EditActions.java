package faultline.gui.action;

import static faultline.gui.action.Keystrokes.menuShiftShortcut;
import static faultline.gui.action.Keystrokes.menuShortcut;

import faultline.gui.edit.UndoController;
import faultline.gui.theme.Glyph;
import java.awt.event.KeyEvent;
import java.util.function.BooleanSupplier;
import javax.swing.JComponent;
import javax.swing.JRootPane;

/** Undo and redo, named after the edits. */
public final class EditActions {

    private final UndoController undoController;
    private final UiAction undo;
    private final UiAction redo;

    /**
     * Creates the actions.
     *
     * @param undoTyping takes back what is being typed in a field; returns whether there was something
     */
    public EditActions(UndoController undoController, BooleanSupplier undoTyping) {
        this.undoController = undoController;
        this.undo = UiAction.of("undo", () -> {
                    if (!undoTyping.getAsBoolean()) {
                        undoController.undo();
                    }
                })
                .withAccelerator(menuShortcut(KeyEvent.VK_Z))
                .withIcon(Glyph.UNDO);
        this.redo = UiAction.of("redo", undoController::redo)
                .withAccelerator(menuShiftShortcut(KeyEvent.VK_Z))
                .withIcon(Glyph.REDO);
        update();
    }

    public void addTo(ActionRegistry actions) {
        actions.add(undo);
        actions.add(redo);
    }

    /** Binds the second key of redo; an action has only one. */
    public void bindTo(JRootPane root) {
        root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(menuShortcut(KeyEvent.VK_Y), redo.key());
        root.getActionMap().put(redo.key(), redo);
    }

    /** Updates the names and states of the actions. */
    public void update() {
        update(undo, undoController.canUndo(), undoController.undoName().orElse(null));
        update(redo, undoController.canRedo(), undoController.redoName().orElse(null));
    }

    /** Shows the state of an action and the name of its edit, null if there is none or it is not known yet. */
    private static void update(UiAction action, boolean possible, String edit) {
        action.setEnabled(possible);
        if (edit == null) {
            action.rename(action.key());
        } else {
            action.rename(action.key() + ".of", edit);
        }
    }
}
