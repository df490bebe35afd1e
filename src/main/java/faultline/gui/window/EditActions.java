package faultline.gui.window;

import static faultline.gui.action.Keystrokes.menu;
import static faultline.gui.action.Keystrokes.menuShift;

import faultline.gui.action.UiAction;
import faultline.gui.edit.EditDesk;
import faultline.gui.theme.Glyph;
import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JRootPane;

/** The actions that take edits back and do them again, named after the edits. */
final class EditActions {

    private final EditDesk desk;
    private final UiAction undo;
    private final UiAction redo;

    EditActions(EditDesk desk) {
        this.desk = desk;
        this.undo = UiAction.of("undo", desk::undo).on(menu(KeyEvent.VK_Z)).drawn(Glyph.UNDO);
        this.redo = UiAction.of("redo", desk::redo).on(menuShift(KeyEvent.VK_Z)).drawn(Glyph.REDO);
        show();
    }

    void addTo(UiActions actions) {
        actions.add(undo);
        actions.add(redo);
    }

    /** The second key of redo, which an action has no room for. */
    void bindTo(JRootPane root) {
        root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(menu(KeyEvent.VK_Y), redo.key());
        root.getActionMap().put(redo.key(), redo);
    }

    /** Makes the actions say what they would do. */
    void show() {
        show(undo, desk.undoName());
        show(redo, desk.redoName());
    }

    private static void show(UiAction action, Optional<String> edit) {
        action.setEnabled(edit.isPresent());
        edit.ifPresentOrElse(name -> action.rename(action.key() + ".of", name), () -> action.rename(action.key()));
    }
}
