package faultline.control.diagnosis;

import faultline.control.diagnosis.EvidenceGrid.RowParity;

/**
 * The cells of a map whose centres lie in a sector, row by row. All rows are found before any is marked, because the
 * processor computes several at once as long as nothing depends on the number of cells in one. The edges of a sector
 * are straight, so their columns change by the same number from row to row; this number is kept in units of 2^-32
 * columns.
 */
final class SectorRows {

    private static final double UNITS = 0x1p32;
    private static final int SHIFT = 32;

    /** An edge that moves by more columns per row than this is treated as horizontal. */
    private static final double HORIZONTAL = 0x1p18;

    private int[] from = new int[EvidenceReach.LEAST.gridSize()];
    private int[] to = new int[EvidenceReach.LEAST.gridSize()];
    private int firstRow;
    private int step;
    private int count;

    /**
     * Finds the cells of a sector.
     *
     * @param x the x coordinate of the apex, metres
     * @param y the y coordinate of the apex, metres
     * @param axisCos cosine of the axis's direction
     * @param axisSin sine of it
     * @param cone the sensor's
     * @param radius metres
     * @param rows the rows that are requested
     */
    void find(double x, double y, double axisCos, double axisSin, ConeTable cone, double radius, RowParity rows) {
        int edge = ConeTable.SAMPLES - 1;
        double leftSin = cone.sin(edge, axisCos, axisSin);
        double rightSin = cone.sin(0, axisCos, axisSin);
        double top = axisSin >= cone.cosHalf() ? 1 : Math.max(0, Math.max(leftSin, rightSin));
        double bottom = axisSin <= -cone.cosHalf() ? -1 : Math.min(0, Math.min(leftSin, rightSin));
        chooseRows(rows, EvidenceGrid.cellOf(y + radius * bottom), EvidenceGrid.cellOf(y + radius * top));
        double origin = x * EvidenceGrid.CELLS_PER_METRE + EvidenceGrid.OFFSET + 0.5;
        double dy = (firstRow + 0.5) * EvidenceGrid.CELL - y;
        double leftSlope = slope(cone.cos(edge, axisCos, axisSin), leftSin);
        double rightSlope = slope(cone.cos(0, axisCos, axisSin), rightSin);
        long left = (long) ((leftSlope * dy * EvidenceGrid.CELLS_PER_METRE + origin) * UNITS);
        long right = (long) ((rightSlope * dy * EvidenceGrid.CELLS_PER_METRE + origin) * UNITS);
        long leftStep = (long) (leftSlope * step * UNITS);
        long rightStep = (long) (rightSlope * step * UNITS);
        // Bits that make the column of an edge harmless in rows in which the edge is not the start or the end.
        int leftStarts = leftSin > 0 ? -1 : 0;
        int rightStarts = rightSin < 0 ? -1 : 0;
        int leftPasses = leftSin < 0 ? 0 : Integer.MAX_VALUE;
        int rightPasses = rightSin > 0 ? 0 : Integer.MAX_VALUE;
        for (int i = 0; i < count; i++) {
            int leftColumn = (int) (left >> SHIFT);
            int rightColumn = (int) (right >> SHIFT);
            // NaN above and below the arc; converted to a column this is 0, so the row is empty.
            double arc = Math.sqrt(radius * radius - dy * dy) * EvidenceGrid.CELLS_PER_METRE;
            from[i] = Math.max((int) (origin - arc), Math.max(leftColumn & leftStarts, rightColumn & rightStarts));
            to[i] = Math.min((int) (origin + arc), Math.min(leftColumn | leftPasses, rightColumn | rightPasses)) - 1;
            dy += step * EvidenceGrid.CELL;
            left += leftStep;
            right += rightStep;
        }
    }

    private void chooseRows(RowParity rows, int first, int last) {
        step = rows.step();
        firstRow = rows.first(first);
        count = (last - firstRow + step) / step;
        if (count > from.length) {
            from = new int[count];
            to = new int[count];
        }
    }

    /** Returns by how many columns an edge moves to the right in a row. */
    private static double slope(double cos, double sin) {
        double slope = cos / sin;
        return Math.abs(slope) < HORIZONTAL ? slope : Math.copySign(HORIZONTAL, slope);
    }

    /** Returns the number of rows. */
    int count() {
        return count;
    }

    /** Returns a row, not wrapped. */
    int row(int index) {
        return firstRow + index * step;
    }

    /** Returns the first column in a row. */
    int from(int index) {
        return from[index];
    }

    /** Returns the last column in a row, less than the first one if there is none. */
    int to(int index) {
        return to[index];
    }
}
