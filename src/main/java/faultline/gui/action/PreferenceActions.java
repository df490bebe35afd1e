package faultline.gui.action;

import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.util.function.Consumer;

/** The choice of language and text size. A change takes effect in all windows at once. */
public final class PreferenceActions {

    private final WindowPreferences preferences;
    private final ActionRegistry actions;
    private final Runnable languageListener;

    /**
     * Adds the actions to a registry; {@code languageListener} is called when the language has changed, before the
     * windows are refreshed.
     */
    public PreferenceActions(WindowPreferences preferences, ActionRegistry actions, Runnable languageListener) {
        this.preferences = preferences;
        this.actions = actions;
        this.languageListener = languageListener;
        addToggles("language", Language.values(), preferences.get(Preference.LANGUAGE), this::setLanguage);
        addToggles("textSize", TextSize.values(), preferences.get(Preference.TEXT_SIZE), this::setTextSize);
    }

    private <E extends Enum<E>> void addToggles(String group, E[] options, E current, Consumer<E> setter) {
        for (E option : options) {
            actions.add(UiAction.toggle(UiAction.key(group, option), option == current, on -> setter.accept(option)));
        }
    }

    /** Stores a language and shows it. */
    public void setLanguage(Language language) {
        preferences.set(Preference.LANGUAGE, language);
        select("language", Language.values(), language);
        if (language != Messages.language()) {
            Messages.setLanguage(language);
            SwingMessages.install();
            actions.allActions().forEach(UiAction::updateTexts);
            languageListener.run();
            WindowRefresh.refreshAll(1);
        }
    }

    /** Stores a text size and shows it. */
    public void setTextSize(TextSize size) {
        preferences.set(Preference.TEXT_SIZE, size);
        select("textSize", TextSize.values(), size);
        TextSize before = TextSize.current();
        if (size != before) {
            size.install();
            Theme.current().install();
            WindowRefresh.refreshAll((double) size.percent() / before.percent());
        }
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
