package faultline.gui.timeline;

import faultline.gui.theme.TextSize;

/**
 * How rows fit into a height: the height of a row, and the number of rows that are visible as a whole. All rows are
 * visible where they would not be too low; otherwise fewer rows of a better height are, and the others by scrolling.
 */
record RowFit(int rowHeight, int rows) {

    /** Heights of a row, pixels: the least if all are visible, the usual one if not, and the greatest. */
    record RowHeights(int least, int usual, int greatest) {

        private static final int LEAST = 13;
        private static final int USUAL = 15;
        private static final int GREATEST = 17;

        /**
         * Returns the heights for the present size of texts. Rows of a larger text may be a little lower, so that more
         * small windows show all lanes.
         */
        static RowHeights scaled() {
            return new RowHeights(
                    Math.max(LEAST, TextSize.scaled(LEAST) - 1), TextSize.scaled(USUAL), TextSize.scaled(GREATEST));
        }
    }

    /** Returns how at least one row fits into a height, pixels. */
    static RowFit of(int room, int rowCount, RowHeights heights) {
        if (room / rowCount >= heights.least) {
            return new RowFit(Math.min(heights.greatest, room / rowCount), rowCount);
        }
        int rows = Math.max(1, room / heights.usual);
        return new RowFit(Math.max(heights.least, Math.min(heights.greatest, room / rows)), rows);
    }

    /** Returns the height of the visible rows, pixels. */
    int height() {
        return rows * rowHeight;
    }
}
