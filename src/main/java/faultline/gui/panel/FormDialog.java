package faultline.gui.panel;

import faultline.gui.theme.ScreenFit;
import java.awt.Component;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JOptionPane;

/** A form in a dialog that can be accepted or cancelled. */
public final class FormDialog {

    private FormDialog() {}

    /**
     * Shows a form, which scrolls if the screen is too small for it, and waits for the answer.
     *
     * @param parent the component behind the dialog
     * @param title the title of the dialog
     * @param form the form
     * @param first the component that has the focus initially
     * @return whether the form was accepted
     */
    public static boolean showDialog(Component parent, String title, JComponent form, Component first) {
        JOptionPane pane =
                new JOptionPane(ScreenFit.scrolling(form), JOptionPane.PLAIN_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
                    @Override
                    public void selectInitialValue() {
                        super.selectInitialValue();
                        first.requestFocusInWindow();
                    }
                };
        NumberSpinner.findIn(form).forEach(NumberSpinner::passKeysOn);
        JDialog dialog = pane.createDialog(parent, title);
        dialog.setResizable(true);
        ScreenFit.pack(dialog);
        dialog.setLocationRelativeTo(parent);
        dialog.setVisible(true);
        dialog.dispose();
        return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue());
    }
}
