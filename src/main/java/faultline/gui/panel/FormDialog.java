package faultline.gui.panel;

import faultline.gui.theme.ScreenFit;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.ComponentListener;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JOptionPane;

/** A form in a dialog that can be accepted or cancelled. */
public final class FormDialog {

    private FormDialog() {}

    /**
     * Shows a form, which scrolls if the screen is too small for it, waits for the answer, and returns whether the form
     * was accepted. The dialog grows with the form; {@code first} has the focus initially.
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
        ComponentListener growth = new Growth(dialog, form.getPreferredSize());
        form.addComponentListener(growth);
        dialog.setLocationRelativeTo(parent);
        dialog.setVisible(true);
        form.removeComponentListener(growth);
        dialog.dispose();
        return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue());
    }

    /** Enlarges a dialog whose form needs more room than before, such as for a field that has become visible. */
    private static final class Growth extends ComponentAdapter {

        private final JDialog dialog;
        private Dimension needed;

        Growth(JDialog dialog, Dimension needed) {
            this.dialog = dialog;
            this.needed = needed;
        }

        @Override
        public void componentResized(ComponentEvent event) {
            Dimension before = needed;
            needed = event.getComponent().getPreferredSize();
            // A dialog that the user makes smaller stays so.
            if (needed.width > before.width || needed.height > before.height) {
                ScreenFit.resize(dialog, 1);
            }
        }
    }
}
