package faultline.gui.panel;

import java.awt.GridBagConstraints;
import java.awt.Insets;

/** Constraints for the cells of a form. */
final class FormConstraints {

    private static final int GAP = 6;

    private FormConstraints() {}

    /** Returns a cell as wide as its component; texts and fields share a baseline. */
    static GridBagConstraints cell(int column, int row) {
        GridBagConstraints constraints = new GridBagConstraints();
        constraints.gridx = column;
        constraints.gridy = row;
        constraints.anchor = GridBagConstraints.BASELINE_LEADING;
        constraints.insets = new Insets(2, column == 0 ? 0 : GAP, 2, 0);
        return constraints;
    }

    /** Returns a cell that fills the remaining width. */
    static GridBagConstraints fillCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.weightx = 1;
        constraints.fill = GridBagConstraints.HORIZONTAL;
        return constraints;
    }

    /** Returns a cell that spans the remaining columns. */
    static GridBagConstraints fillRow(int column, int row) {
        GridBagConstraints constraints = fillCell(column, row);
        constraints.gridwidth = GridBagConstraints.REMAINDER;
        return constraints;
    }

    /** Returns a cell for a component without a baseline, centred in its row. */
    static GridBagConstraints centredCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.anchor = GridBagConstraints.CENTER;
        return constraints;
    }

    /** Returns a cell for a component without a baseline, at the start of its column and centred in its row. */
    static GridBagConstraints leadingCell(int column, int row) {
        GridBagConstraints constraints = cell(column, row);
        constraints.anchor = GridBagConstraints.LINE_START;
        return constraints;
    }
}
