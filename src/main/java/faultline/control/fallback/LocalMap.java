package faultline.control.fallback;

import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.SensorDiagnosis;
import java.util.Arrays;

/**
 * A map of the surroundings that trusted sensors have recently seen: for each place, the distance to the nearest
 * surface, and whether a sensor has seen it free. Distances are computed by two chamfer sweeps over a window of cells
 * (Borgefors 1986). They are up to 8 % too large along slanted walls, which is too much far from the wall: a large
 * window computes the exact distance of each of the few points that are needed, which also takes less time.
 */
final class LocalMap {

    private static final int FAR = 10_000;
    private static final int STRAIGHT = 5;
    private static final int DIAGONAL = 7;

    /** The place of the row in a number for a cell, above the column. */
    private static final int ROW_SHIFT = 16;

    private static final int COLUMN_MASK = (1 << ROW_SHIFT) - 1;

    /** The number of cells along each axis of the window, as the wanted distance needs it. */
    private int window;
    /** The distance from each cell to the nearest surface; before it is computed, 0 for surfaces and else far. */
    private int[] surface = {};

    private boolean swept = true;

    /** Whether each distance is computed when it is needed. */
    private boolean exact;

    /** The columns and rows of the cells with surfaces, row by row. */
    private int[] surfaceCells = {};

    private int surfaceCount;
    /** The time at which each cell of each row was last seen free. */
    private int[][] lastFree = {};

    private int[] lastHit = {};
    private int since = Integer.MAX_VALUE;
    /** The square of the distance from the robot's cell within which it knows the ground, in cells. */
    private double ownSquare;

    private int column;
    private int row;
    private double x;
    private double y;

    /**
     * Updates this map from the evidence; older evidence than a limit does not count. Places near the robot are free
     * unless a surface was seen there, because no sensor can see them.
     *
     * @param diagnosis the evidence, and the sensors that are trusted
     * @param memory the limit, on the motion clock
     * @param bodyRadius the distance from the robot's centre up to which places are near, metres
     */
    void refresh(SensorDiagnosis diagnosis, int memory, double bodyRadius) {
        EvidenceGrid grid = diagnosis.grid();
        resize(diagnosis.reach().windowSize());
        exact = diagnosis.reach().isLarge();
        x = diagnosis.reckoning().x();
        y = diagnosis.reckoning().y();
        column = EvidenceGrid.cellOf(x) - window / 2;
        row = EvidenceGrid.cellOf(y) - window / 2;
        since = diagnosis.now() - memory;
        ownSquare = bodyRadius * bodyRadius / (EvidenceGrid.CELL * EvidenceGrid.CELL);
        // The source after all sensors is the robot's body.
        int asked = diagnosis.trusted() | 1 << diagnosis.sensors();
        Arrays.fill(surface, FAR);
        surfaceCount = 0;
        for (int r = 0; r < window; r++) {
            grid.findLastFree(column, row + r, since, asked, lastFree[r]);
            if (grid.findLastHit(column, row + r, since, asked, lastHit)) {
                markSurfaces(r);
            }
        }
        swept = surfaceCount == 0;
    }

    private void resize(int cells) {
        if (cells != window) {
            window = cells;
            surface = new int[cells * cells];
            surfaceCells = new int[cells * cells];
            lastFree = new int[cells][cells];
            lastHit = new int[cells];
        }
    }

    private void markSurfaces(int r) {
        for (int c = 0; c < window; c++) {
            if (lastHit[c] >= since && lastFree[r][c] < since) {
                surface[r * window + c] = 0;
                surfaceCells[surfaceCount++] = r << ROW_SHIFT | c;
            }
        }
    }

    /** Computes distances from zeros; there are none before a given row. */
    private static void sweep(int[] d, int window, int firstRow) {
        for (int r = Math.max(1, firstRow); r < window - 1; r++) {
            int before = d[r * window];
            for (int i = r * window + 1; i < (r + 1) * window - 1; i++) {
                int slant = Math.min(d[i - window - 1], d[i - window + 1]) + DIAGONAL;
                int other = Math.min(d[i], Math.min(d[i - window] + STRAIGHT, slant));
                before = Math.min(other, before + STRAIGHT);
                d[i] = before;
            }
        }
        for (int r = window - 2; r > 0; r--) {
            int before = d[(r + 1) * window - 1];
            for (int i = (r + 1) * window - 2; i > r * window; i--) {
                int slant = Math.min(d[i + window + 1], d[i + window - 1]) + DIAGONAL;
                int other = Math.min(d[i], Math.min(d[i + window] + STRAIGHT, slant));
                before = Math.min(other, before + STRAIGHT);
                d[i] = before;
            }
        }
    }

    /** Returns the distance from a point to the nearest surface, metres. */
    double toSurface(double px, double py) {
        int c = columnOf(px);
        int r = rowOf(py);
        if (!contains(c, r)) {
            return 0;
        }
        if (exact) {
            return exactDistance(c, r);
        }
        if (!swept) {
            sweep(surface, window, surfaceCells[0] >> ROW_SHIFT);
            swept = true;
        }
        return surface[r * window + c] * (EvidenceGrid.CELL / STRAIGHT);
    }

    private double exactDistance(int c, int r) {
        int least = FAR * FAR;
        for (int i = 0; i < surfaceCount; i++) {
            int dx = (surfaceCells[i] & COLUMN_MASK) - c;
            int dy = (surfaceCells[i] >> ROW_SHIFT) - r;
            least = Math.min(least, dx * dx + dy * dy);
        }
        return Math.sqrt(least) * EvidenceGrid.CELL;
    }

    /**
     * Returns the distance from a point of a path to the nearest surface on the path's left, or ahead of the platform.
     *
     * @param px the point's x coordinate, metres
     * @param py its y coordinate, metres
     * @param cos the cosine of the direction of the path
     * @param sin its sine
     * @param half half the platform's width, metres
     * @return metres, computed as by {@link #toSurface}; 0 if the point is not in the window
     */
    double toSurfaceOnLeft(double px, double py, double cos, double sin, double half) {
        int c = columnOf(px);
        int r = rowOf(py);
        if (!contains(c, r)) {
            return 0;
        }
        double least = FAR;
        for (int i = 0; i < surfaceCount; i++) {
            int dx = (surfaceCells[i] & COLUMN_MASK) - c;
            int dy = (surfaceCells[i] >> ROW_SHIFT) - r;
            double left = (dy * cos - dx * sin) * EvidenceGrid.CELL;
            if (left >= 0 || left > -half && dx * cos + dy * sin > 0) {
                least = Math.min(least, exact ? Math.sqrt(dx * dx + dy * dy) : chamfer(dx, dy));
            }
        }
        return least * EvidenceGrid.CELL;
    }

    /** Returns the distance that the sweeps give for a vector, in cells. */
    private static double chamfer(int dx, int dy) {
        int most = Math.max(Math.abs(dx), Math.abs(dy));
        int fewest = Math.min(Math.abs(dx), Math.abs(dy));
        return most + fewest * ((double) (DIAGONAL - STRAIGHT) / STRAIGHT);
    }

    /** Returns whether a point is known to be free. */
    boolean isKnown(double px, double py) {
        int c = columnOf(px);
        int r = rowOf(py);
        return contains(c, r) && (lastFree[r][c] >= since || isOwn(c, r) && surface[r * window + c] > 0);
    }

    private boolean isOwn(int c, int r) {
        int dx = c - window / 2;
        int dy = r - window / 2;
        return dx * dx + dy * dy <= ownSquare;
    }

    private int columnOf(double px) {
        return EvidenceGrid.cellOf(px) - column;
    }

    private int rowOf(double py) {
        return EvidenceGrid.cellOf(py) - row;
    }

    private boolean contains(int c, int r) {
        return c >= 0 && r >= 0 && c < window && r < window;
    }

    /**
     * Returns the direction of the nearest surface within some angle of a direction.
     *
     * @param towards the direction, radians
     * @param within the maximum angle from it, radians
     * @param limit the maximum distance, metres
     * @return the direction, radians; not a number if there is none
     */
    double bearingOfSurface(double towards, double within, double limit) {
        double best = limit * limit;
        double found = Double.NaN;
        double ax = StrictMath.cos(towards);
        double ay = StrictMath.sin(towards);
        double cosWithin = StrictMath.cos(within);
        for (int i = 0; i < surfaceCount; i++) {
            double dy = (row + (surfaceCells[i] >> ROW_SHIFT) + 0.5) * EvidenceGrid.CELL - y;
            double dx = (column + (surfaceCells[i] & COLUMN_MASK) + 0.5) * EvidenceGrid.CELL - x;
            double square = dx * dx + dy * dy;
            if (square < best && dx * ax + dy * ay >= cosWithin * Math.sqrt(square)) {
                best = square;
                found = StrictMath.atan2(dy, dx);
            }
        }
        return found;
    }
}
