package faultline.gui.action;

import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import java.awt.event.ActionEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/**
 * One thing that the user can do, with its name, tool tip, key and icon. The texts come from the key
 * {@code action.KEY}.
 */
public final class UiAction extends AbstractAction {

    private final String key;
    private final transient Consumer<UiAction> handler;

    private UiAction(String key, Consumer<UiAction> handler) {
        this.key = key;
        this.handler = handler;
        rename(key);
        putValue(ACTION_COMMAND_KEY, key);
    }

    /**
     * An action that is done.
     *
     * @param key of its texts
     * @param handler what it does, on the event dispatch thread
     * @return the action, without a key and an icon
     */
    public static UiAction of(String key, Runnable handler) {
        return new UiAction(key, action -> handler.run());
    }

    /**
     * An action that is switched on and off.
     *
     * @param key of its texts
     * @param on how it stands at first
     * @param handler told how it stands from now on, on the event dispatch thread
     * @return the action, without a key and an icon
     */
    public static UiAction toggle(String key, boolean on, Consumer<Boolean> handler) {
        UiAction action = new UiAction(key, self -> handler.accept(self.isOn()));
        action.putValue(SELECTED_KEY, on);
        return action;
    }

    /**
     * Gives the action a key.
     *
     * @param stroke the key
     * @return this action
     */
    public UiAction withAccelerator(KeyStroke stroke) {
        putValue(ACCELERATOR_KEY, stroke);
        updateToolTip();
        return this;
    }

    /**
     * Gives the action an icon for tool bars.
     *
     * @param glyph the drawing
     * @return this action
     */
    public UiAction withIcon(Glyph glyph) {
        putValue(LARGE_ICON_KEY, glyph.icon());
        return this;
    }

    /**
     * Gives the action a name with a gap, and the texts of its own key otherwise.
     *
     * @param textKey of the name
     * @param value goes into the gap
     */
    public void rename(String textKey, String value) {
        rename(key);
        putValue(Action.NAME, Messages.get("action." + textKey, value).replaceFirst("&", ""));
    }

    /**
     * Gives the action the texts of another key.
     *
     * @param textKey of the texts
     */
    public void rename(String textKey) {
        String name = Messages.get("action." + textKey);
        int mark = name.indexOf('&');
        putValue(Action.NAME, name.replace("&", ""));
        putValue(MNEMONIC_KEY, mark < 0 ? null : (int) Character.toUpperCase(name.charAt(mark + 1)));
        putValue(LONG_DESCRIPTION, Messages.get("action." + textKey + ".tip"));
        updateToolTip();
    }

    private void updateToolTip() {
        String tip = (String) getValue(LONG_DESCRIPTION);
        putValue(
                SHORT_DESCRIPTION,
                accelerator()
                        .map(stroke -> tip + " (" + Keystrokes.toText(stroke) + ")")
                        .orElse(tip));
    }

    /**
     * The key of its texts, which is its name for the program.
     *
     * @return as given when it was made
     */
    public String key() {
        return key;
    }

    /**
     * Its name without the mark of the mnemonic.
     *
     * @return for people
     */
    public String name() {
        return (String) getValue(NAME);
    }

    /**
     * Its key.
     *
     * @return empty where it has none
     */
    public Optional<KeyStroke> accelerator() {
        return Optional.ofNullable((KeyStroke) getValue(ACCELERATOR_KEY));
    }

    /**
     * How a switch stands.
     *
     * @return true for on
     */
    public boolean isOn() {
        return Boolean.TRUE.equals(getValue(SELECTED_KEY));
    }

    /**
     * Shows a switch in another position, without doing anything.
     *
     * @param on how it stands from now on
     */
    public void setOn(boolean on) {
        putValue(SELECTED_KEY, on);
    }

    /**
     * Whether it is switched on and off rather than done.
     *
     * @return true for a switch
     */
    public boolean isToggle() {
        return getValue(SELECTED_KEY) != null;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        handler.accept(this);
    }
}
