package faultline.gui.theme;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Binds keys of focused components to actions. */
public final class KeyBindings {

    private KeyBindings() {}

    /** Runs an action when a key, such as {@code shift F10}, is pressed while a component has the focus. */
    public static void bind(JComponent component, String key, Runnable action) {
        component.getInputMap(JComponent.WHEN_FOCUSED).put(KeyStroke.getKeyStroke(key), key);
        component.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }
}
