package faultline.gui.action;

import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import java.awt.Component;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JOptionPane;

/** The choice of language and text size. A change takes effect in the next window, and a message says so. */
public final class PreferenceActions {

    private final Component parent;
    private final WindowPreferences preferences;

    public PreferenceActions(Component parent, WindowPreferences preferences) {
        this.parent = parent;
        this.preferences = preferences;
    }

    public void addTo(ActionRegistry actions) {
        toggleGroup("language", Language.values(), preferences.language(), preferences::setLanguage)
                .forEach(actions::add);
        toggleGroup("textSize", TextSize.values(), preferences.textSize(), preferences::setTextSize)
                .forEach(actions::add);
    }

    private <E extends Enum<E>> List<UiAction> toggleGroup(String group, E[] options, E current, Consumer<E> setter) {
        UiAction[] actions = new UiAction[options.length];
        for (int i = 0; i < options.length; i++) {
            E option = options[i];
            String key = UiAction.key(group, option);
            actions[i] = UiAction.toggle(key, option == current, on -> {
                List.of(actions).forEach(action -> action.setOn(action.key().equals(key)));
                setter.accept(option);
                if (option != current) {
                    JOptionPane.showMessageDialog(
                            parent,
                            Messages.get("choice.later"),
                            Messages.get("choice.title"),
                            JOptionPane.INFORMATION_MESSAGE);
                }
            });
        }
        return List.of(actions);
    }
}
