package faultline.gui.window;

import faultline.gui.action.UiAction;
import faultline.gui.text.Language;
import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import java.awt.Component;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JOptionPane;

/** The choice of language and of the size of texts. Both are made when the window is, so a change shows in the next one, which is told at once. */
final class ChoiceActions {

    private final Component parent;
    private final WindowMemory memory;

    ChoiceActions(Component parent, WindowMemory memory) {
        this.parent = parent;
        this.memory = memory;
    }

    void addTo(UiActions actions) {
        choice("language", Language.values(), memory.language(), memory::keepLanguage).forEach(actions::add);
        choice("textSize", TextSize.values(), memory.textSize(), memory::keepTextSize).forEach(actions::add);
    }

    /** The key of the action that makes a choice. */
    static String key(String group, Enum<?> option) {
        return group + option.name().charAt(0) + option.name().substring(1).toLowerCase(Locale.ROOT);
    }

    private <E extends Enum<E>> List<UiAction> choice(String group, E[] options, E now, Consumer<E> keep) {
        UiAction[] actions = new UiAction[options.length];
        for (int i = 0; i < options.length; i++) {
            E option = options[i];
            actions[i] = UiAction.toggle(key(group, option), option == now, on -> {
                Arrays.stream(actions).forEach(action -> action.putValue(UiAction.SELECTED_KEY, action.key().equals(key(group, option))));
                keep.accept(option);
                if (option != now) {
                    JOptionPane.showMessageDialog(parent, Texts.text("choice.later"), Texts.text("choice.title"), JOptionPane.INFORMATION_MESSAGE);
                }
            });
        }
        return List.of(actions);
    }
}
