package faultline.control.fallback;

import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.SensorDiagnosis;
import java.util.Arrays;

/**
 * A map of the surroundings that trusted sensors have recently seen: for each place, the distance to the nearest
 * surface, and whether a sensor has seen it free. Distances are computed by two chamfer sweeps over a window of cells
 * (Borgefors 1986).
 */
final class LocalMap {

    /** The number of cells along each axis of the window. */
    private static final int WINDOW = 72;

    private static final int FAR = 10_000;
    private static final int STRAIGHT = 5;
    private static final int DIAGONAL = 7;

    /** The distance from each cell to the nearest surface; before it is computed, 0 for surfaces and else far. */
    private final int[] surface = new int[WINDOW * WINDOW];

    private boolean swept = true;
    /** The cells with surfaces, row by row. */
    private final int[] surfaceCells = new int[WINDOW * WINDOW];

    private int surfaceCount;
    /** The time at which each cell of each row was last seen free. */
    private final int[][] lastFree = new int[WINDOW][WINDOW];

    private final int[] lastHit = new int[WINDOW];
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
     */
    void refresh(SensorDiagnosis diagnosis, int bodySource, int memory, double bodyRadius) {
        EvidenceGrid grid = diagnosis.grid();
        x = diagnosis.reckoning().x();
        y = diagnosis.reckoning().y();
        column = EvidenceGrid.cellOf(x) - WINDOW / 2;
        row = EvidenceGrid.cellOf(y) - WINDOW / 2;
        since = diagnosis.now() - memory;
        ownSquare = bodyRadius * bodyRadius / (EvidenceGrid.CELL * EvidenceGrid.CELL);
        int asked = diagnosis.trusted() | 1 << bodySource;
        Arrays.fill(surface, FAR);
        surfaceCount = 0;
        for (int r = 0; r < WINDOW; r++) {
            grid.findLastFree(column, row + r, since, asked, lastFree[r]);
            if (grid.findLastHit(column, row + r, since, asked, lastHit)) {
                markSurfaces(r);
            }
        }
        swept = surfaceCount == 0;
    }

    private void markSurfaces(int r) {
        for (int c = 0; c < WINDOW; c++) {
            if (lastHit[c] >= since && lastFree[r][c] < since) {
                surface[r * WINDOW + c] = 0;
                surfaceCells[surfaceCount++] = r * WINDOW + c;
            }
        }
    }

    /** Computes distances from zeros; there are none before a given row. */
    private static void sweep(int[] d, int firstRow) {
        for (int r = Math.max(1, firstRow); r < WINDOW - 1; r++) {
            int before = d[r * WINDOW];
            for (int i = r * WINDOW + 1; i < (r + 1) * WINDOW - 1; i++) {
                int slant = Math.min(d[i - WINDOW - 1], d[i - WINDOW + 1]) + DIAGONAL;
                int other = Math.min(d[i], Math.min(d[i - WINDOW] + STRAIGHT, slant));
                before = Math.min(other, before + STRAIGHT);
                d[i] = before;
            }
        }
        for (int r = WINDOW - 2; r > 0; r--) {
            int before = d[(r + 1) * WINDOW - 1];
            for (int i = (r + 1) * WINDOW - 2; i > r * WINDOW; i--) {
                int slant = Math.min(d[i + WINDOW + 1], d[i + WINDOW - 1]) + DIAGONAL;
                int other = Math.min(d[i], Math.min(d[i + WINDOW] + STRAIGHT, slant));
                before = Math.min(other, before + STRAIGHT);
                d[i] = before;
            }
        }
    }

    /** Returns the distance from a point to the nearest surface, metres. */
    double toSurface(double px, double py) {
        if (!swept) {
            sweep(surface, surfaceCells[0] / WINDOW);
            swept = true;
        }
        int cell = cellAt(px, py);
        return cell < 0 ? 0 : surface[cell] * (EvidenceGrid.CELL / STRAIGHT);
    }

    /** Returns whether a point is known to be free. */
    boolean isKnown(double px, double py) {
        int cell = cellAt(px, py);
        return cell >= 0 && (lastFree[cell / WINDOW][cell % WINDOW] >= since || isOwn(cell) && surface[cell] > 0);
    }

    private boolean isOwn(int cell) {
        int dx = cell % WINDOW - WINDOW / 2;
        int dy = cell / WINDOW - WINDOW / 2;
        return dx * dx + dy * dy <= ownSquare;
    }

    /** Returns the cell at a point, negative outside the window. */
    private int cellAt(double px, double py) {
        int c = EvidenceGrid.cellOf(px) - column;
        int r = EvidenceGrid.cellOf(py) - row;
        return c < 0 || r < 0 || c >= WINDOW || r >= WINDOW ? -1 : r * WINDOW + c;
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
            double dy = (row + surfaceCells[i] / WINDOW + 0.5) * EvidenceGrid.CELL - y;
            double dx = (column + surfaceCells[i] % WINDOW + 0.5) * EvidenceGrid.CELL - x;
            double square = dx * dx + dy * dy;
            if (square < best && dx * ax + dy * ay >= cosWithin * Math.sqrt(square)) {
                best = square;
                found = StrictMath.atan2(dy, dx);
            }
        }
        return found;
    }
}
