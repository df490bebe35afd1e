package faultline.gui.panel;

import java.awt.Component;
import java.awt.FlowLayout;
import java.util.OptionalDouble;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.JPanel;

/**
 * Asks for a number.
 *
 * @param title the title of the dialog
 * @param key the key of the name of the number
 * @param unit the unit
 * @param min the smallest value
 * @param max the largest value
 * @param step the step of the arrows
 */
public record NumberDialog(String title, String key, String unit, double min, double max, double step) {

    private static final int COLUMNS = 6;

    /**
     * Shows the dialog and waits for the answer.
     *
     * @param parent the component behind the dialog
     * @param value the initial value
     * @return the number, empty if cancelled
     */
    public OptionalDouble showDialog(Component parent, double value) {
        NumberSpinner field = new NumberSpinner("0.00##", min, max, step, ignored -> {})
                .withName(key)
                .withColumns(COLUMNS);
        field.setLimits(min, max, value);
        JPanel line = new JPanel(new FlowLayout(FlowLayout.LEADING));
        line.add(FormConstraints.label(key, field));
        line.add(field);
        line.add(new MutedLabel(unit));
        // The field has the focus initially.
        JOptionPane pane = new JOptionPane(line, JOptionPane.PLAIN_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
            @Override
            public void selectInitialValue() {
                super.selectInitialValue();
                field.textField().requestFocusInWindow();
            }
        };
        JDialog dialog = pane.createDialog(parent, title);
        dialog.setVisible(true);
        dialog.dispose();
        field.commitPendingEdit();
        return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue())
                ? OptionalDouble.of(field.doubleValue())
                : OptionalDouble.empty();
    }
}
