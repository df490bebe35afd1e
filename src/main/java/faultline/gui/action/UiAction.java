package faultline.gui.action;

import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.UiText;
import java.awt.event.ActionEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/** An action of the user, with its name, tool tip, accelerator and icon. Its texts have the key {@code action.KEY}. */
public final class UiAction extends AbstractAction {

    private final String key;
    private final transient Consumer<UiAction> handler;
    /** Sets the texts again in the current language. */
    private transient Runnable texts = () -> {};

    private UiAction(String key, Consumer<UiAction> handler) {
        this.key = key;
        this.handler = handler;
        rename(key);
        putValue(ACTION_COMMAND_KEY, key);
    }

    /** Creates an action that calls a handler, without accelerator and icon. */
    public static UiAction of(String key, Runnable handler) {
        return new UiAction(key, action -> handler.run());
    }

    /** Creates an action that passes itself to a handler, without accelerator and icon. */
    static UiAction ofSelf(String key, Consumer<UiAction> handler) {
        return new UiAction(key, handler);
    }

    /** Creates an action that is switched on and off, and calls a handler with its new state. */
    public static UiAction toggle(String key, boolean on, Consumer<Boolean> handler) {
        UiAction action = new UiAction(key, self -> handler.accept(self.isOn()));
        action.putValue(SELECTED_KEY, on);
        return action;
    }

    /** Returns the key of the action that chooses an option, such as {@code languagePolish}. */
    static String key(String group, Enum<?> option) {
        return group + option.name().charAt(0) + option.name().substring(1).toLowerCase(Locale.ROOT);
    }

    /** Sets the accelerator; returns this action. */
    public UiAction withAccelerator(KeyStroke stroke) {
        putValue(ACCELERATOR_KEY, stroke);
        updateToolTip();
        return this;
    }

    /** Sets the icon for tool bars; returns this action. */
    public UiAction withIcon(Glyph glyph) {
        putValue(LARGE_ICON_KEY, glyph.icon());
        return this;
    }

    /**
     * Sets a name with a placeholder for a value, which is shortened if it is long; the other texts are those of its
     * own key.
     */
    public void rename(String textKey, String value) {
        texts = () -> {
            setTexts(key);
            setName(Messages.get("action." + textKey, UiText.shortName(value)));
        };
        texts.run();
    }

    /** Sets the texts of another key. */
    public void rename(String textKey) {
        texts = () -> setTexts(textKey);
        texts.run();
    }

    /** Sets the texts again in the current language. */
    void updateTexts() {
        texts.run();
    }

    private void setTexts(String textKey) {
        setName(Messages.get("action." + textKey));
        putValue(LONG_DESCRIPTION, Messages.get("action." + textKey + ".tip"));
        updateToolTip();
    }

    /** Sets a name; the letter after its ampersand is the mnemonic. */
    private void setName(String marked) {
        int mark = marked.indexOf('&');
        // Buttons underline the first such letter of a new name, also if the index stays the same.
        putValue(DISPLAYED_MNEMONIC_INDEX_KEY, null);
        putValue(Action.NAME, marked.replaceFirst("&", ""));
        putValue(MNEMONIC_KEY, mark < 0 ? null : (int) Character.toUpperCase(marked.charAt(mark + 1)));
        putValue(DISPLAYED_MNEMONIC_INDEX_KEY, mark < 0 ? null : mark);
    }

    private void updateToolTip() {
        String tip = (String) getValue(LONG_DESCRIPTION);
        putValue(
                SHORT_DESCRIPTION,
                accelerator()
                        .map(stroke -> tip + " (" + Keystrokes.toText(stroke) + ")")
                        .orElse(tip));
    }

    /** Returns the key of the texts, which identifies the action. */
    public String key() {
        return key;
    }

    /** Returns the name without the mark of the mnemonic. */
    public String name() {
        return (String) getValue(NAME);
    }

    /** Returns the accelerator; empty if there is none. */
    public Optional<KeyStroke> accelerator() {
        return Optional.ofNullable((KeyStroke) getValue(ACCELERATOR_KEY));
    }

    /** Returns whether a toggle is on. */
    public boolean isOn() {
        return Boolean.TRUE.equals(getValue(SELECTED_KEY));
    }

    /** Sets the state of a toggle without calling its handler. */
    public void setOn(boolean on) {
        putValue(SELECTED_KEY, on);
    }

    /** Returns whether the action is switched on and off. */
    public boolean isToggle() {
        return getValue(SELECTED_KEY) != null;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        handler.accept(this);
    }
}
