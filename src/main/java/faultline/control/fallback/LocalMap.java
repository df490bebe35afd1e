package faultline.control.fallback;

import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.SensorDiagnosis;
import java.util.Arrays;

/**
 * The surroundings as trusted sensors recently saw them: for each place, the distance to the nearest surface, and
 * whether a sensor has seen it free. Distances are computed by two chamfer sweeps over a window of cells (Borgefors
 * 1986).
 */
final class LocalMap {

    /** The number of cells along each axis of the window. */
    private static final int WINDOW = 72;

    private static final int FAR = 10_000;
    private static final int STRAIGHT = 5;
    private static final int DIAGONAL = 7;

    private final int[] surface = new int[WINDOW * WINDOW];
    /** The cells with surfaces, row by row. */
    private final int[] surfaceCells = new int[WINDOW * WINDOW];

    private int surfaceCount;
    private final boolean[] known = new boolean[WINDOW * WINDOW];
    private final int[] lastFree = new int[WINDOW];
    private final int[] lastHit = new int[WINDOW];
    private int column;
    private int row;
    private double x;
    private double y;

    /**
     * Updates this map from the evidence; what is older than a memory does not count. Places near the robot are free
     * unless a surface was seen there, because no sensor can see them.
     */
    void refresh(SensorDiagnosis diagnosis, int bodySource, int memory, double bodyRadius) {
        EvidenceGrid grid = diagnosis.grid();
        x = diagnosis.reckoning().x();
        y = diagnosis.reckoning().y();
        column = EvidenceGrid.cellOf(x) - WINDOW / 2;
        row = EvidenceGrid.cellOf(y) - WINDOW / 2;
        int since = diagnosis.now() - memory;
        int asked = diagnosis.trusted() | 1 << bodySource;
        surfaceCount = 0;
        double ownSquare = bodyRadius * bodyRadius / (EvidenceGrid.CELL * EvidenceGrid.CELL);
        for (int r = 0; r < WINDOW; r++) {
            Arrays.fill(lastFree, Integer.MIN_VALUE);
            Arrays.fill(lastHit, Integer.MIN_VALUE);
            grid.findLast(column, row + r, since, asked, lastFree, lastHit);
            int dy = r - WINDOW / 2;
            for (int c = 0; c < WINDOW; c++) {
                int dx = c - WINDOW / 2;
                boolean own = dx * dx + dy * dy <= ownSquare;
                boolean free = lastFree[c] >= since;
                boolean hit = !free && lastHit[c] >= since;
                int cell = r * WINDOW + c;
                surface[cell] = hit ? 0 : FAR;
                known[cell] = free || own && !hit;
                if (hit) {
                    surfaceCells[surfaceCount++] = cell;
                }
            }
        }
        if (surfaceCount > 0) {
            sweep(surface, surfaceCells[0] / WINDOW);
        }
    }

    /** Computes distances from zeros, of which there are none before a row. */
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
        int cell = cellAt(px, py);
        return cell < 0 ? 0 : surface[cell] * (EvidenceGrid.CELL / STRAIGHT);
    }

    /** Returns whether a point is known to be free. */
    boolean isKnown(double px, double py) {
        int cell = cellAt(px, py);
        return cell >= 0 && known[cell];
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
     * @param towards radians
     * @param within radians
     * @param limit metres
     * @return radians; not a number if there is none
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
