package faultline.gui.panel;

import java.awt.Component;
import java.awt.FlowLayout;
import java.util.OptionalDouble;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;

/**
 * Asks for a number in front of a window.
 *
 * @param title of the dialog
 * @param name what the number is
 * @param unit for people
 * @param min allowed
 * @param max allowed
 * @param step of the field's arrows
 */
public record NumberDialog(String title, String name, String unit, double min, double max, double step) {

    private static final int COLUMNS = 6;

    /**
     * Asks and waits for the answer.
     *
     * @param parent what the dialog is in front of
     * @param value that shows at first
     * @return the number, empty where the user thinks better of it
     */
    public OptionalDouble showDialog(Component parent, double value) {
        NumberSpinner field = new NumberSpinner("0.00##", min, max, step, ignored -> {})
                .withName(name)
                .withColumns(COLUMNS);
        field.setLimits(min, max, value);
        JPanel line = new JPanel(new FlowLayout(FlowLayout.LEADING));
        JLabel label = new JLabel(name);
        label.setLabelFor(field);
        line.add(label);
        line.add(field);
        line.add(new MutedLabel(unit));
        // So that one can type at once.
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
