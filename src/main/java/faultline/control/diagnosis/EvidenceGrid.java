package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * An occupancy grid around the robot that wraps at its borders. Each cell remembers for each source, that is, a sensor
 * or the robot's own body, when that source last saw it free and when it last saw a surface there. Moments are those of
 * a clock that runs with the robot's motion, because motion makes dead reckoning uncertain. Moments before a limit that
 * each reader gives do not count, so cells need not be cleared as the robot moves.
 */
public final class EvidenceGrid {

    /** The side of a cell, metres. */
    public static final double CELL = 0.025;

    static final double CELLS_PER_METRE = 1 / CELL;

    /** Makes all columns positive; a multiple of every size. */
    static final int OFFSET = 1 << 30;

    /**
     * The rows of a sector that are marked. Marking every second row takes half the time, and the next mark covers the
     * others.
     */
    enum RowParity {
        ALL(1, 0),
        EVEN(2, 0),
        ODD(2, 1);

        private final int step;
        private final int parity;

        RowParity(int step, int parity) {
            this.step = step;
            this.parity = parity;
        }

        /** Returns the difference between two marked rows. */
        int step() {
            return step;
        }

        /** Returns the first row to mark at or after a row. */
        int first(int row) {
            return row + (row + parity & step - 1);
        }
    }

    private final int sources;
    /** The number of cells along each axis, a power of two. */
    private int size;
    /** The bits of a column or row that remain when it wraps. */
    private int wrap;
    /** For each source, the moments of all cells: a mark writes many cells of one source. */
    private int[] free;
    /** For each cell, the moments of all sources: a test reads one cell of many sources. */
    private int[] hit;

    /** The latest moment in each row of each source. */
    private int[] lastFreeInRow;

    private int[] lastHitInRow;
    private final SectorRows sector = new SectorRows();

    EvidenceGrid(int sources) {
        this.sources = sources;
        resize(EvidenceReach.LEAST.gridSize());
    }

    /**
     * Changes the size and forgets all evidence.
     *
     * @param cells the number of cells along each axis, a power of two
     */
    final void resize(int cells) {
        size = cells;
        wrap = cells - 1;
        free = new int[cells * cells * sources];
        hit = new int[cells * cells * sources];
        lastFreeInRow = new int[cells * sources];
        lastHitInRow = new int[cells * sources];
    }

    /** Forgets all evidence. */
    void clear() {
        Arrays.fill(free, 0);
        Arrays.fill(hit, 0);
        Arrays.fill(lastFreeInRow, 0);
        Arrays.fill(lastHitInRow, 0);
    }

    /**
     * Returns the cell of a coordinate.
     *
     * @param coordinate metres
     * @return column or row, not wrapped
     */
    public static int cellOf(double coordinate) {
        return (int) Math.floor(coordinate * CELLS_PER_METRE);
    }

    private int cell(int column, int row) {
        return (row & wrap) * size + (column & wrap);
    }

    /**
     * Returns which of some sources saw a cell free.
     *
     * @param column the cell's column, not wrapped
     * @param row the cell's row, not wrapped
     * @param since the oldest moment that counts
     * @param asked a bit for each source
     * @return the bits of those that did
     */
    public int freeBy(int column, int row, int since, int asked) {
        int cell = cell(column, row);
        int plane = size * size;
        int found = 0;
        for (int rest = asked; rest != 0; rest &= rest - 1) {
            int source = Integer.numberOfTrailingZeros(rest);
            if (free[source * plane + cell] >= since) {
                found |= 1 << source;
            }
        }
        return found;
    }

    /** Returns whether some of the sources asked have seen a surface in a cell since a moment. */
    boolean isHit(int column, int row, int since, int asked) {
        int first = cell(column, row) * sources;
        for (int rest = asked; rest != 0; rest &= rest - 1) {
            if (hit[first + Integer.numberOfTrailingZeros(rest)] >= since) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds when some sources last saw the cells of a part of a row free.
     *
     * @param column the first cell's column, not wrapped
     * @param row the cells' row, not wrapped
     * @param since the oldest moment that counts; older ones may be omitted
     * @param asked a bit for each source
     * @param latest receives the latest moment for one cell after the other; no longer than a row
     * @return whether some may have been seen since then
     */
    public boolean findLastFree(int column, int row, int since, int asked, int[] latest) {
        Arrays.fill(latest, Integer.MIN_VALUE);
        int recent = recent(lastFreeInRow, row, since, asked);
        for (int rest = recent; rest != 0; rest &= rest - 1) {
            int line = Integer.numberOfTrailingZeros(rest) * size + (row & wrap);
            raise(latest, line * size, column & wrap);
        }
        return recent != 0;
    }

    private void raise(int[] latest, int base, int start) {
        int beforeWrap = Math.min(latest.length, size - start);
        for (int i = 0; i < beforeWrap; i++) {
            latest[i] = Math.max(latest[i], free[base + start + i]);
        }
        for (int i = beforeWrap; i < latest.length; i++) {
            latest[i] = Math.max(latest[i], free[base - beforeWrap + i]);
        }
    }

    /** Returns those of some sources that have marked a cell of a row since a moment, a bit for each. */
    private int recent(int[] lastInRow, int row, int since, int asked) {
        int found = 0;
        for (int rest = asked; rest != 0; rest &= rest - 1) {
            int source = Integer.numberOfTrailingZeros(rest);
            if (lastInRow[source * size + (row & wrap)] >= since) {
                found |= 1 << source;
            }
        }
        return found;
    }

    /**
     * Finds when some sources last saw a surface in the cells of a part of a row.
     *
     * @param column the first cell's column, not wrapped
     * @param row the cells' row, not wrapped
     * @param since the oldest moment that counts; older ones may be omitted
     * @param asked a bit for each source
     * @param latest receives the latest moment for one cell after the other; no longer than a row
     * @return whether there may be surfaces seen since then
     */
    public boolean findLastHit(int column, int row, int since, int asked, int[] latest) {
        Arrays.fill(latest, Integer.MIN_VALUE);
        int recent = recent(lastHitInRow, row, since, asked);
        if (recent == 0) {
            return false;
        }
        for (int i = 0; i < latest.length; i++) {
            int first = cell(column + i, row) * sources;
            for (int rest = recent; rest != 0; rest &= rest - 1) {
                latest[i] = Math.max(latest[i], hit[first + Integer.numberOfTrailingZeros(rest)]);
            }
        }
        return true;
    }

    /** Records that a source saw a surface in a cell. */
    void markHit(int source, int column, int row, int moment) {
        hit[cell(column, row) * sources + source] = moment;
        lastHitInRow[source * size + (row & wrap)] = moment;
    }

    /** Records that a source occupied a disc or saw it free. */
    void markDisc(int source, double x, double y, double radius, int moment) {
        int firstRow = cellOf(y - radius);
        // The number of rows also ends the loop if the last one is the greatest integer, very far from the start.
        int rows = cellOf(y + radius) - firstRow + 1;
        for (int i = 0; i < rows; i++) {
            int row = firstRow + i;
            double dy = (row + 0.5) * CELL - y;
            double half = Math.sqrt(Math.max(0, radius * radius - dy * dy));
            // Truncation rounds down because the sum is positive.
            int first = (int) ((x - half) * CELLS_PER_METRE + OFFSET + 0.5);
            int end = (int) ((x + half) * CELLS_PER_METRE + OFFSET + 0.5);
            markRow(source, row, first, end - 1, moment);
        }
    }

    /**
     * Records that a source saw a sector free: all cells whose centres lie in it.
     *
     * @param source the sensor
     * @param x the x coordinate of the apex, metres
     * @param y the y coordinate of the apex, metres
     * @param axisCos cosine of the axis's direction
     * @param axisSin sine of it
     * @param cone the sensor's
     * @param radius metres
     * @param moment now
     * @param rows the rows that are marked
     */
    void markSector(
            int source,
            double x,
            double y,
            double axisCos,
            double axisSin,
            ConeTable cone,
            double radius,
            int moment,
            RowParity rows) {
        sector.find(x, y, axisCos, axisSin, cone, radius, rows);
        for (int i = 0; i < sector.count(); i++) {
            markRow(source, sector.row(i), sector.from(i), sector.to(i), moment);
        }
    }

    /**
     * Marks the cells of a row in groups of four, and the last cell repeatedly: rows are short, and a loop over single
     * cells whose number is different each time takes longer.
     */
    private void markRow(int source, int row, int first, int last, int moment) {
        if (first > last) {
            return;
        }
        int line = source * size + (row & wrap);
        int base = line * size;
        lastFreeInRow[line] = moment;
        // Very far from the start, columns reach the greatest integer, so the loop counts from the first one. A row has
        // no more cells than the grid is wide.
        int end = Math.min(last - first, size - 1);
        for (int i = 0; i <= end; i += 4) {
            free[base + (first + i & wrap)] = moment;
            free[base + (first + Math.min(i + 1, end) & wrap)] = moment;
            free[base + (first + Math.min(i + 2, end) & wrap)] = moment;
            free[base + (first + Math.min(i + 3, end) & wrap)] = moment;
        }
    }
}
