package faultline.gui.theme;

import java.awt.FlowLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.KeyStroke;

/** The buttons and keys that dialogs have in common. */
public final class DialogButtons {

    private DialogButtons() {}

    /** Runs an action if Escape is pressed in a dialog. */
    public static void onEscape(JDialog dialog, Runnable action) {
        dialog.getRootPane()
                .registerKeyboardAction(
                        event -> action.run(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    /**
     * Returns a row with the only button of a dialog, which Enter and Escape press, too.
     *
     * @param dialog the dialog
     * @param key the key of the text of the button
     * @param action the action of the button
     */
    public static JPanel createSingleButton(JDialog dialog, String key, Runnable action) {
        JButton button = UiText.button(key);
        button.addActionListener(event -> action.run());
        dialog.getRootPane().setDefaultButton(button);
        onEscape(dialog, action);
        JPanel row = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        row.add(button);
        return row;
    }
}
