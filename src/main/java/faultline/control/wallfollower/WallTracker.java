package faultline.control.wallfollower;

/**
 * Tracks the wall on the left through one sensor's readings and dead reckoning: its distance r and the robot's heading
 * gamma relative to it, positive towards the wall. A steady-state Kalman filter of second order (an alpha-beta filter),
 * whose bandwidth depends on the distance rolled and not on time.
 *
 * <p>Along a wall r' = -v sin gamma and gamma' = omega - v k, where k is the curvature of the path that keeps the
 * distance: 0 along a straight wall, 1 / radius around a corner. If the wall bends in another way, there is an
 * innovation: a difference between the reading and its prediction.
 */
final class WallTracker {

    /** The distance over which the filter averages, as a share of the distance from the centre to the wall. */
    private static final double MEMORY_SHARE = 0.086;

    /** A reading that differs by more than this is of another object, metres. */
    private static final double OUTLIER_THRESHOLD = 0.05;

    /** The distance over which innovations are averaged, metres. */
    private static final double DRIFT_DISTANCE = 0.2;

    /** The number of innovations that are kept. */
    static final int MAX_INNOVATIONS = 16;

    private final double[] innovations = new double[MAX_INNOVATIONS];
    private int innovationCount;
    private int nextInnovation;
    private double distanceSinceReset;
    private boolean switched;
    private double distance;
    private double heading;
    private double innovation;
    private double previousInnovation;
    private double drift;

    /** Restarts at a reading, parallel to the wall. */
    void start(double reading) {
        distance = reading;
        heading = 0;
        switched = false;
        clearInnovations();
    }

    /** Predicts the state after some motion. */
    void predict(double rolled, double turned, double curvature) {
        double middle = heading + (turned - curvature * rolled) / 2;
        heading += turned - curvature * rolled;
        distance -= rolled * StrictMath.sin(middle);
        distanceSinceReset += Math.abs(rolled);
        previousInnovation = innovation;
        innovation = 0;
    }

    /** Corrects the state by a reading after some motion. */
    void correct(double reading, double rolled, double radius) {
        double share = correctDistance(reading, rolled, radius);
        if (rolled > 0) {
            heading -= share * share / rolled * innovation;
        }
    }

    /** Corrects the distance only, and returns the filter's gain. */
    double correctDistance(double reading, double rolled, double radius) {
        innovation = reading - distance;
        if (Math.abs(innovation) > OUTLIER_THRESHOLD) {
            distance = reading;
            innovation = 0;
            return 0;
        }
        innovations[nextInnovation] = innovation;
        nextInnovation = (nextInnovation + 1) % MAX_INNOVATIONS;
        innovationCount = Math.min(innovationCount + 1, MAX_INNOVATIONS);
        drift += Math.min(1, Math.abs(rolled) / DRIFT_DISTANCE) * (innovation - drift);
        // Critically damped at the bandwidth 1 / (MEMORY radius) per metre.
        double share = Math.min(0.5, Math.abs(rolled) / (MEMORY_SHARE * radius));
        distance += Math.min(1, 1.4 * share) * innovation;
        return share;
    }

    /** Turns the tracked heading because the wall has another direction. */
    void turnHeading(double angle) {
        switched = true;
        heading += angle;
        clearInnovations();
    }

    private void clearInnovations() {
        innovation = 0;
        previousInnovation = 0;
        innovationCount = 0;
        distanceSinceReset = 0;
        drift = 0;
    }

    /** Returns the distance of the wall, metres. */
    double distance() {
        return distance;
    }

    /** Returns the robot's heading relative to the wall, radians, positive towards it. */
    double heading() {
        return heading;
    }

    /** Returns by how much the last reading exceeded its prediction, metres. */
    double innovation() {
        return innovation;
    }

    /** Returns by how much the reading before the last one exceeded its prediction, metres. */
    double previousInnovation() {
        return previousInnovation;
    }

    /** Returns the distance rolled since the heading was last set, metres. */
    double distanceSinceReset() {
        return distanceSinceReset;
    }

    /** Returns whether the heading was last set because the wall bends, not at the start along a wall. */
    boolean switched() {
        return switched;
    }

    /** Returns the distance rolled that the filter takes into account, metres. */
    static double memory(double radius) {
        return MEMORY_SHARE * radius;
    }

    /** Returns the number of innovations that are kept, of those since the heading was last set. */
    int innovationCount() {
        return innovationCount;
    }

    /** Returns the mean of the last innovations, metres; 0 if the count is 0. */
    double meanInnovation(int count) {
        double sum = 0;
        for (int i = 1; i <= count; i++) {
            sum += innovations[Math.floorMod(nextInnovation - i, MAX_INNOVATIONS)];
        }
        return count == 0 ? 0 : sum / count;
    }

    /**
     * Returns by how much recent readings exceeded their predictions on average, metres: this detects a small bend that
     * is below the noise of a single reading.
     */
    double drift() {
        return drift;
    }

    /**
     * Returns the share of a reading's noise that remains in the {@link #drift}, from the distance between two
     * readings.
     */
    static double driftNoiseShare(double rolled) {
        return Math.sqrt(Math.abs(rolled) / DRIFT_DISTANCE / 2);
    }

    /**
     * Returns the final innovation at a corner, at a radius from the robot's centre, if the tracker takes its two sides
     * for one straight wall, metres: (MEMORY radius)^2 / radius.
     */
    static double cornerInnovation(double radius) {
        return MEMORY_SHARE * MEMORY_SHARE * radius;
    }
}
