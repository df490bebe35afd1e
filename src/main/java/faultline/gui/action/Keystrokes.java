package faultline.gui.action;

import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;

/** Key strokes of actions, and their texts. */
public final class Keystrokes {

    private static final int OTHER_MODIFIERS = InputEvent.CTRL_DOWN_MASK
            | InputEvent.ALT_DOWN_MASK
            | InputEvent.META_DOWN_MASK
            | InputEvent.ALT_GRAPH_DOWN_MASK;

    /** The roles of components with entries. */
    private static final Set<AccessibleRole> LISTS =
            Set.of(AccessibleRole.LIST, AccessibleRole.TABLE, AccessibleRole.COMBO_BOX);

    /** In the order in which they are written. */
    private static final List<Modifier> MODIFIERS = List.of(
            new Modifier(InputEvent.META_DOWN_MASK, "key.meta"),
            new Modifier(InputEvent.CTRL_DOWN_MASK, "key.ctrl"),
            new Modifier(InputEvent.ALT_DOWN_MASK, "key.alt"),
            new Modifier(InputEvent.SHIFT_DOWN_MASK, "key.shift"));

    /** A modifier key, and the key of its text. */
    private record Modifier(int mask, String name) {}

    private Keystrokes() {}

    /** Returns the stroke of a key alone, given a code of {@link KeyEvent}. */
    public static KeyStroke unmodified(int key) {
        return KeyStroke.getKeyStroke(key, 0);
    }

    /** Returns the stroke that types a character, with whichever keys do so on the keyboard. */
    public static KeyStroke character(char sign) {
        return KeyStroke.getKeyStroke(sign);
    }

    /** Returns the stroke of a key with the platform's menu modifier, which is Ctrl on most. */
    public static KeyStroke menuShortcut(int key) {
        return KeyStroke.getKeyStroke(key, KeyBindings.menuMask());
    }

    /**
     * Returns a stroke of a character with the menu modifier, for display only. Different keys type the character on
     * different keyboards, and none does while the modifier is held, so the keys must be bound as well.
     */
    public static KeyStroke menuCharacter(char sign) {
        return KeyStroke.getKeyStroke(Character.valueOf(sign), KeyBindings.menuMask());
    }

    /** Returns whether a stroke is one of {@link #menuCharacter}, for display only. */
    public static boolean isMenuCharacter(KeyStroke stroke) {
        return stroke.getKeyCode() == KeyEvent.VK_UNDEFINED && (stroke.getModifiers() & KeyBindings.menuMask()) != 0;
    }

    /** Returns the stroke of a key with the platform's menu modifier and Shift. */
    public static KeyStroke menuShiftShortcut(int key) {
        return KeyStroke.getKeyStroke(key, KeyBindings.menuMask() | InputEvent.SHIFT_DOWN_MASK);
    }

    /** Returns a text that mentions Ctrl with the name of the platform's menu modifier in its place. */
    public static String withMenuModifier(String text) {
        return withModifier(text, KeyBindings.menuMask());
    }

    static String withModifier(String text, int menuMask) {
        return menuMask == InputEvent.META_DOWN_MASK
                ? text.replace(Messages.get("key.ctrl"), Messages.get("key.meta"))
                : text;
    }

    /** Returns a stroke in the language of the window, such as Ctrl+O or [. */
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

    /** Keys named by a word have a text; others are named by their label on the keyboard. */
    private static String keyText(int code) {
        String key = unmodified(code).toString().replace("pressed ", "key.");
        return Messages.contains(key) ? Messages.get(key) : KeyEvent.getKeyText(code);
    }

    /** Returns whether a stroke may also type a character: it has no modifier but Shift and is not a function key. */
    public static boolean producesText(KeyStroke stroke) {
        boolean functionKey = stroke.getKeyCode() >= KeyEvent.VK_F1 && stroke.getKeyCode() <= KeyEvent.VK_F12;
        return !functionKey && (stroke.getModifiers() & OTHER_MODIFIERS) == 0;
    }

    /**
     * Returns whether a stroke is typed into the focused component, which may be null: a text component, or, for a
     * digit, a list, a table or a combo box, where the user means an entry or a number.
     */
    public static boolean isTypedInto(Component focused, KeyStroke stroke) {
        return focused instanceof JTextComponent && producesText(stroke)
                || isDigit(stroke) && focused instanceof Accessible list && isList(list.getAccessibleContext());
    }

    private static boolean isDigit(KeyStroke stroke) {
        return producesText(stroke) && stroke.getKeyCode() >= KeyEvent.VK_0 && stroke.getKeyCode() <= KeyEvent.VK_9;
    }

    private static boolean isList(AccessibleContext context) {
        return LISTS.contains(context.getAccessibleRole());
    }
}
