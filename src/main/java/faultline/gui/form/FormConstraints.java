package faultline.gui.form;

import faultline.gui.theme.UiText;
import java.awt.GridBagConstraints;
import java.awt.Insets;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Constraints for the cells of a form. */
public final class FormConstraints {

    public static final int GAP = 6;

    private FormConstraints() {}

    /** Returns the label of a field, given the key of its text. */
    public static JLabel label(String key, JComponent field) {
        JLabel label = UiText.label(key);
        label.setLabelFor(field);
        return label;
    }

    /**
     * Adds a row with a label, which is returned, and a field. The key is that of the label's text, which is also the
     * accessible name of the field. A number field keeps its width; another one fills the row.
     */
    public static JLabel addRow(JPanel form, int row, String key, JComponent field) {
        JLabel label = label(key, field);
        GridBagConstraints cell = fillRow(1, row);
        if (field instanceof NumberSpinner number) {
            number.withName(key);
            cell.fill = GridBagConstraints.NONE;
        }
        UiText.name(field, key);
        form.add(label, cell(0, row));
        form.add(field, cell);
        return label;
    }

    /** Returns a cell as wide as its component; texts and fields share a baseline. */
    public static GridBagConstraints cell(int column, int row) {
        GridBagConstraints constraints = new GridBagConstraints();
        constraints.gridx = column;
        constraints.gridy = row;
        constraints.anchor = GridBagConstraints.BASELINE_LEADING;
        constraints.insets = new Insets(2, column == 0 ? 0 : GAP, 2, 0);
        return constraints;
    }

    /** Returns a cell that fills the remaining width. */
    public static GridBagConstraints fillCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.weightx = 1;
        constraints.fill = GridBagConstraints.HORIZONTAL;
        return constraints;
    }

    /** Returns a cell that spans the remaining columns. */
    public static GridBagConstraints fillRow(int column, int row) {
        GridBagConstraints constraints = fillCell(column, row);
        constraints.gridwidth = GridBagConstraints.REMAINDER;
        return constraints;
    }

    /** Returns a cell for a component without a baseline, centred in its row. */
    public static GridBagConstraints centredCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.anchor = GridBagConstraints.CENTER;
        return constraints;
    }

    /** Returns a cell for a component without a baseline, at the start of its column and centred in its row. */
    public static GridBagConstraints leadingCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.anchor = GridBagConstraints.LINE_START;
        return constraints;
    }
}
