package faultline.gui.theme;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Binds keys of focused components to actions. */
public final class KeyBindings {

    private KeyBindings() {}

    /**
     * Runs an action when a key is pressed while a component has the focus. The key is written as in {@code shift F10};
     * {@code menu C} has the platform's menu modifier.
     */
    public static void bind(JComponent component, String key, Runnable action) {
        bind(component, key, () -> true, action);
    }

    /** Runs an action as {@link #bind} does, but only if a condition holds; if not, the key may be that of a menu. */
    public static void bind(JComponent component, String key, BooleanSupplier condition, Runnable action) {
        component.getInputMap(JComponent.WHEN_FOCUSED).put(stroke(key, menuMask()), key);
        component.getActionMap().put(key, new AbstractAction() {
            @Override
            public boolean isEnabled() {
                return condition.getAsBoolean();
            }

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    static KeyStroke stroke(String key, int menuMask) {
        String menu = menuMask == InputEvent.META_DOWN_MASK ? "meta " : "ctrl ";
        return KeyStroke.getKeyStroke(key.replace("menu ", menu));
    }

    /** Returns the modifier of the keys of menus, a mask of {@link InputEvent}; Ctrl if no display defines it. */
    public static int menuMask() {
        return GraphicsEnvironment.isHeadless()
                ? InputEvent.CTRL_DOWN_MASK
                : Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    }
}
