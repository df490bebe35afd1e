package faultline.gui.action;

import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import java.awt.Component;
import java.util.function.Consumer;
import javax.swing.JOptionPane;

/** The choice of language and text size. A change takes effect in the next window, and a message says so. */
public final class PreferenceActions {

    private final Component parent;
    private final WindowPreferences preferences;
    private final ActionRegistry actions;

    public PreferenceActions(Component parent, WindowPreferences preferences, ActionRegistry actions) {
        this.parent = parent;
        this.preferences = preferences;
        this.actions = actions;
        addToggles("language", Language.values(), preferences.language(), this::setLanguage);
        addToggles("textSize", TextSize.values(), preferences.textSize(), this::setTextSize);
    }

    private <E extends Enum<E>> void addToggles(String group, E[] options, E current, Consumer<E> setter) {
        for (E option : options) {
            actions.add(UiAction.toggle(UiAction.key(group, option), option == current, on -> {
                setter.accept(option);
                if (option != current) {
                    JOptionPane.showMessageDialog(
                            parent,
                            Messages.get("choice.later"),
                            Messages.get("choice.title"),
                            JOptionPane.INFORMATION_MESSAGE);
                }
            }));
        }
    }

    /** Stores the language of the next window. */
    public void setLanguage(Language language) {
        preferences.setLanguage(language);
        select("language", Language.values(), language);
    }

    /** Stores the text size of the next window. */
    public void setTextSize(TextSize size) {
        preferences.setTextSize(size);
        select("textSize", TextSize.values(), size);
    }

    private <E extends Enum<E>> void select(String group, E[] options, E chosen) {
        for (E option : options) {
            actions.get(UiAction.key(group, option)).setOn(option == chosen);
        }
    }

    /** Returns the name of the action that chooses an option. */
    public <E extends Enum<E>> String name(String group, E option) {
        return actions.get(UiAction.key(group, option)).name();
    }
}
