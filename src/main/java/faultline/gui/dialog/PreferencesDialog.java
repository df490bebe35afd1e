package faultline.gui.dialog;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.PreferenceActions;
import faultline.gui.action.ThemeAction;
import faultline.gui.action.UiAction;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NamedChoice;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeChoice;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.GridBagLayout;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JRootPane;

/** All remembered settings in one modal dialog. A change takes effect at once. */
public final class PreferencesDialog extends JDialog {

    private static final List<String> TOGGLES =
            List.of("timeline", "instruments", "controlPanel", "pathStates", "pathFaults", "snapGrid", "snapAngle");

    private final JPanel form = new JPanel(new GridBagLayout());
    private int row;

    private PreferencesDialog(
            Window owner,
            ActionRegistry actions,
            WindowPreferences preferences,
            PreferenceActions choices,
            ThemeAction theme) {
        super(owner, ModalityType.APPLICATION_MODAL);
        RefreshSteps.add(getRootPane(), pane -> setTitle(Messages.get("preferences.title")));
        addChoice(
                "preferences.theme",
                ThemeChoice.values(),
                preferences.get(Preference.THEME),
                choice -> Messages.get("preferences.theme." + choice.name()),
                theme::choose);
        addChoice(
                "preferences.language",
                Language.values(),
                preferences.get(Preference.LANGUAGE),
                option -> choices.name("language", option),
                choices::setLanguage);
        addChoice(
                "preferences.textSize",
                TextSize.values(),
                preferences.get(Preference.TEXT_SIZE),
                option -> choices.name("textSize", option),
                choices::setTextSize);
        JCheckBox gallery = UiText.text(new JCheckBox(), "preferences.gallery");
        gallery.setSelected(preferences.get(Preference.GALLERY_SHOWN));
        gallery.addActionListener(event -> preferences.set(Preference.GALLERY_SHOWN, gallery.isSelected()));
        form.add(gallery, FormConstraints.fillRow(1, row++));
        TOGGLES.forEach(key -> form.add(createToggle(actions.get(key)), FormConstraints.fillRow(1, row++)));
        JPanel content = new JPanel(new BorderLayout(0, 16));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        content.add(ScreenFit.scrolling(form), BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "dialog.close", this::dispose), BorderLayout.SOUTH);
        setContentPane(content);
        ScreenFit.pack(this);
        setLocationRelativeTo(owner);
    }

    /** Adds the action that shows the dialog. The menu shows the comma by its sign, so its key is bound here. */
    public static void addTo(
            ActionRegistry actions,
            JFrame owner,
            WindowPreferences preferences,
            PreferenceActions choices,
            ThemeAction theme) {
        UiAction show = UiAction.of(
                        "preferences",
                        () -> new PreferencesDialog(owner, actions, preferences, choices, theme).setVisible(true))
                .withAccelerator(Keystrokes.menuCharacter(','));
        actions.add(show);
        JRootPane root = owner.getRootPane();
        root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(Keystrokes.menuShortcut(KeyEvent.VK_COMMA), show.key());
        root.getActionMap().put(show.key(), show);
    }

    private <E> void addChoice(String key, E[] options, E current, Function<E, String> name, Consumer<E> onChange) {
        NamedChoice<E> choice = new NamedChoice<>(options, name, onChange);
        choice.setValue(current);
        FormConstraints.addRow(form, row++, key, choice);
    }

    /** Creates a toggle without the mnemonic of its action, which belongs to a menu: two menus may have the same. */
    private static JCheckBox createToggle(UiAction action) {
        JCheckBox toggle = RefreshSteps.add(new JCheckBox(action), box -> box.setMnemonic(0));
        toggle.setToolTipText(null);
        return toggle;
    }
}
