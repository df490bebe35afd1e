package faultline.gui.panel;

import java.awt.GridBagConstraints;
import java.awt.Insets;

/** Places in a grid of controls. */
final class FormConstraints {

    private static final int GAP = 6;

    private FormConstraints() {}

    /** A cell that is as wide as what it holds; text and fields stand on one base line. */
    static GridBagConstraints cell(int column, int row) {
        GridBagConstraints place = new GridBagConstraints();
        place.gridx = column;
        place.gridy = row;
        place.anchor = GridBagConstraints.BASELINE_LEADING;
        place.insets = new Insets(2, column == 0 ? 0 : GAP, 2, 0);
        return place;
    }

    /** A cell that takes the width that is left. */
    static GridBagConstraints fillCell(int column, int row) {
        GridBagConstraints place = cell(column, row);
        place.weightx = 1;
        place.fill = GridBagConstraints.HORIZONTAL;
        return place;
    }

    /** A cell that takes all columns that are left. */
    static GridBagConstraints fillRow(int column, int row) {
        GridBagConstraints place = fillCell(column, row);
        place.gridwidth = GridBagConstraints.REMAINDER;
        return place;
    }

    /** A cell for something without a base line, in the middle of its row. */
    static GridBagConstraints centredCell(int column, int row) {
        GridBagConstraints place = cell(column, row);
        place.anchor = GridBagConstraints.CENTER;
        return place;
    }

    /** A cell for something without a base line, at the left of its column and in the middle of its row. */
    static GridBagConstraints leadingCell(int column, int row) {
        GridBagConstraints place = cell(column, row);
        place.anchor = GridBagConstraints.LINE_START;
        return place;
    }
}
