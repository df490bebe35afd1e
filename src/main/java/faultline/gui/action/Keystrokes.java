package faultline.gui.action;

import faultline.gui.text.Messages;
import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;

/** Keys of actions, and how they are written. */
public final class Keystrokes {

    private static final int OTHER_MODIFIERS = InputEvent.CTRL_DOWN_MASK
            | InputEvent.ALT_DOWN_MASK
            | InputEvent.META_DOWN_MASK
            | InputEvent.ALT_GRAPH_DOWN_MASK;

    /** In the order in which they are written. */
    private static final List<Modifier> MODIFIERS = List.of(
            new Modifier(InputEvent.META_DOWN_MASK, "key.meta"),
            new Modifier(InputEvent.CTRL_DOWN_MASK, "key.ctrl"),
            new Modifier(InputEvent.ALT_DOWN_MASK, "key.alt"),
            new Modifier(InputEvent.SHIFT_DOWN_MASK, "key.shift"));

    /** A key that is held, and the key of its name. */
    private record Modifier(int mask, String name) {}

    private Keystrokes() {}

    /**
     * A key alone.
     *
     * @param key a code of {@link KeyEvent}
     * @return the stroke
     */
    public static KeyStroke unmodified(int key) {
        return KeyStroke.getKeyStroke(key, 0);
    }

    /**
     * A sign, whichever keys make it on this keyboard.
     *
     * @param sign the sign
     * @return the stroke
     */
    public static KeyStroke character(char sign) {
        return KeyStroke.getKeyStroke(sign);
    }

    /**
     * A key with the platform's menu key, which is Ctrl on most.
     *
     * @param key a code of {@link KeyEvent}
     * @return the stroke
     */
    public static KeyStroke menuShortcut(int key) {
        return KeyStroke.getKeyStroke(key, menuMask());
    }

    /**
     * A sign with the platform's menu key, for people to read. Which keys make the sign differs from keyboard to
     * keyboard, and none types it while the menu key is down: the keys have to be bound besides.
     *
     * @param sign the sign
     * @return the stroke
     */
    public static KeyStroke menuCharacter(char sign) {
        return KeyStroke.getKeyStroke(Character.valueOf(sign), menuMask());
    }

    /**
     * Whether a stroke is one of {@link #menuCharacter}.
     *
     * @param stroke the stroke
     * @return true where it is only to be read
     */
    public static boolean isMenuCharacter(KeyStroke stroke) {
        return stroke.getKeyCode() == KeyEvent.VK_UNDEFINED && (stroke.getModifiers() & menuMask()) != 0;
    }

    /**
     * A key with the platform's menu key and Shift.
     *
     * @param key a code of {@link KeyEvent}
     * @return the stroke
     */
    public static KeyStroke menuShiftShortcut(int key) {
        return KeyStroke.getKeyStroke(key, menuMask() | InputEvent.SHIFT_DOWN_MASK);
    }

    /** Without a display nobody can say what the menu key is. */
    private static int menuMask() {
        return GraphicsEnvironment.isHeadless()
                ? InputEvent.CTRL_DOWN_MASK
                : Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    }

    /**
     * A stroke for people, in the language of the window; the machine's may be another.
     *
     * @param stroke the stroke
     * @return such as Ctrl+O, or [
     */
    public static String toText(KeyStroke stroke) {
        String modifiers = MODIFIERS.stream()
                .filter(modifier -> (stroke.getModifiers() & modifier.mask()) != 0)
                .map(modifier -> Messages.get(modifier.name()) + "+")
                .collect(Collectors.joining());
        return modifiers
                + (stroke.getKeyCode() == KeyEvent.VK_UNDEFINED
                        ? String.valueOf(stroke.getKeyChar())
                        : keyText(stroke.getKeyCode()));
    }

    /** Keys that are called by a word have it in the texts; others are called by what is printed on them. */
    private static String keyText(int code) {
        String key = unmodified(code).toString().replace("pressed ", "key.");
        return Messages.contains(key) ? Messages.get(key) : KeyEvent.getKeyText(code);
    }

    /**
     * Whether a stroke would also type something: one without modifiers, or with Shift only, that is no function key.
     *
     * @param stroke the stroke
     * @return true where a text field with the focus must get it
     */
    public static boolean producesText(KeyStroke stroke) {
        boolean functionKey = stroke.getKeyCode() >= KeyEvent.VK_F1 && stroke.getKeyCode() <= KeyEvent.VK_F12;
        return !functionKey && (stroke.getModifiers() & OTHER_MODIFIERS) == 0;
    }

    /**
     * Whether a component keeps a stroke to itself.
     *
     * @param focused the component with the focus, may be null as the focus manager has it
     * @param stroke the stroke
     * @return true where it is typed into a text
     */
    public static boolean isTypedInto(Component focused, KeyStroke stroke) {
        return focused instanceof JTextComponent && producesText(stroke);
    }
}
