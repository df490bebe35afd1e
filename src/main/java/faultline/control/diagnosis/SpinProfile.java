package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * The distances from the centre of a spin that one sensor measures in all directions. A straight wall is nearest to a
 * cone either inside it or at one of its borders; there, the slope of the distances over the direction shows the angle
 * to the wall, so that the distance does not depend on where the sensor is mounted.
 */
final class SpinProfile {

    /** The angle between two directions, radians. */
    static final double STEP = StrictMath.toRadians(2);

    /** The number of directions. */
    static final int DIRECTIONS = 180;

    /** Distances that differ by more than this from a line through their neighbours belong to an edge, metres. */
    private static final double MAX_BEND = 0.02;

    /** The maximum slope, because a turn is not known exactly, metres per radian. */
    private static final double MAX_SLOPE = 2;

    /** Up to this relative slope the wall may be nearest inside the cone, 1 per radian. */
    private static final double INSIDE = 0.1;

    /** The measured distances; not a number if nothing was seen. */
    private final double[] measured = new double[DIRECTIONS];
    /** The direction of a measurement relative to the middle of its step, in steps. */
    private final double[] offsets = new double[DIRECTIONS];

    private final double[] distances = new double[DIRECTIONS];
    /** The indices of the directions that have a distance, in any order. */
    private final int[] known = new int[DIRECTIONS];

    private int count;

    /** Whether the distances are those of the last spin. */
    private boolean computed;

    /** Requires that the distances are computed again. */
    void reset() {
        computed = false;
    }

    /**
     * Computes the distances from the centre, unless they are known.
     *
     * @param sensor the sensor
     * @param log what it measured
     */
    void compute(InspectedSensor sensor, SpinLog log) {
        if (computed) {
            return;
        }
        computed = true;
        Arrays.fill(measured, Double.NaN);
        Arrays.fill(distances, Double.NaN);
        count = 0;
        for (int i = 0; i < log.size(); i++) {
            add(log.direction(i, sensor.cone()), log.distance(i, sensor));
        }
        computeDistances(sensor.cone());
    }

    private void add(double direction, double distance) {
        double steps = direction / STEP;
        double whole = Math.floor(steps);
        int index = Math.floorMod((int) whole, DIRECTIONS);
        measured[index] = distance;
        offsets[index] = steps - whole - 0.5;
    }

    private void computeDistances(MountedCone cone) {
        double cos = StrictMath.cos(cone.bearing());
        double sin = StrictMath.sin(cone.bearing());
        double ahead = cone.x() * cos + cone.y() * sin;
        double aside = cone.y() * cos - cone.x() * sin;
        double halfCos = StrictMath.cos(cone.half());
        double halfSin = StrictMath.sin(cone.half());
        for (int i = 0; i < DIRECTIONS; i++) {
            if (Double.isNaN(measured[i])) {
                continue;
            }
            double slope = slope(i);
            double tan = slope / (measured[i] + ahead);
            double border = Math.max(-1, Math.min(1, tan / INSIDE));
            // For a wall at an angle u beyond the border, tan u is the relative slope. Not a number if the slope is
            // not.
            distances[i] = measured[i]
                    - slope * STEP * offsets[i]
                    + ahead * (1 + Math.abs(border) * (halfCos - 1) - Math.abs(tan) * halfSin)
                    - aside * (border * halfSin + tan * halfCos);
            if (!Double.isNaN(distances[i])) {
                known[count++] = i;
            }
        }
    }

    /** Returns the slope at a direction, metres per radian; not a number at an edge or if a neighbour is missing. */
    private double slope(int index) {
        int before = neighbour(index, -1);
        int after = neighbour(index, 1);
        int beforeIndex = wrap(index + before);
        int afterIndex = wrap(index + after);
        double back = offsets[index] - offsets[beforeIndex] - before;
        double forth = offsets[afterIndex] - offsets[index] + after;
        double slope = (measured[afterIndex] - measured[beforeIndex]) / (back + forth);
        double bend = measured[index] - measured[beforeIndex] - slope * back;
        return Math.abs(bend) < MAX_BEND && Math.abs(slope) < MAX_SLOPE * STEP ? slope / STEP : Double.NaN;
    }

    /** Returns the steps to the next measurement, one or two. */
    private int neighbour(int index, int step) {
        return Double.isNaN(measured[wrap(index + step)]) ? 2 * step : step;
    }

    /** Returns the index of a direction that is less than a turn outside the indices. */
    private static int wrap(int index) {
        return index < 0 ? index + DIRECTIONS : index < DIRECTIONS ? index : index - DIRECTIONS;
    }

    /**
     * Finds by how much the distances exceed those of another sensor in the same directions.
     *
     * @param other the profile of the other
     * @param differences receives the differences in metres; at least {@link #DIRECTIONS} long
     * @return the number of directions in which both are known
     */
    int subtract(SpinProfile other, double[] differences) {
        int found = 0;
        for (int i = 0; i < count; i++) {
            double by = distances[known[i]] - other.distances[known[i]];
            if (!Double.isNaN(by)) {
                differences[found++] = by;
            }
        }
        return found;
    }
}
