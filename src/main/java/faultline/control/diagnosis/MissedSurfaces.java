package faultline.control.diagnosis;

import faultline.sensor.Reading;

/** Finds surfaces that the front sensor misses: another sensor predicts or sees them. */
final class MissedSurfaces {

    /**
     * The minimum speed of a robot that drives, metres per second. A slower robot turns on the spot, where surfaces may
     * come near.
     */
    private static final double DRIVING = 0.06;

    /**
     * A place on the robot's path where a surface was predicted that the front sensor did not see.
     *
     * @param x metres
     * @param y metres
     * @param cos the cosine of the direction of the path
     * @param sin the sine of it
     */
    record PredictedSurface(double x, double y, double cos, double sin) {

        /** The surface may be nearer than predicted by this, metres. */
        private static final double NEARER = 0.05;

        /** It may be farther by this, metres. */
        static final double FARTHER = 0.15;

        private static final double STEP = EvidenceGrid.CELL;

        /** Returns the surface at a distance from a sensor that looks ahead. */
        static PredictedSurface ahead(DeadReckoning reckoning, MountedCone cone, double distance) {
            double cos = reckoning.headingCos();
            double sin = reckoning.headingSin();
            double forward = cone.x() + distance;
            return new PredictedSurface(
                    reckoning.x() + cos * forward - sin * cone.y(),
                    reckoning.y() + sin * forward + cos * cone.y(),
                    cos,
                    sin);
        }

        /** Returns whether the whole part of the path where the surface can be was seen free. */
        boolean isRefuted(EvidenceGrid grid, int oldest, int asked) {
            for (double along = -NEARER; along < FARTHER; along += STEP) {
                int column = EvidenceGrid.cellOf(x + along * cos);
                int row = EvidenceGrid.cellOf(y + along * sin);
                if (grid.freeBy(column, row, oldest, asked) == 0) {
                    return false;
                }
            }
            return true;
        }
    }

    private final InspectedSensor[] sensors;
    /** The last surface that each sensor missed. */
    private final PredictedSurface[] missed;

    private final TrustAssessment assessment;
    private final EvidenceGrid grid;
    private final DeadReckoning reckoning;

    MissedSurfaces(InspectedSensor[] sensors, TrustAssessment assessment, EvidenceGrid grid, DeadReckoning reckoning) {
        this.sensors = sensors;
        this.missed = new PredictedSurface[sensors.length];
        this.assessment = assessment;
        this.grid = grid;
        this.reckoning = reckoning;
    }

    /**
     * Tests whether a sensor that looks diagonally ahead predicts a surface that the front sensor does not see.
     *
     * @param sensor the sensor that sees something
     * @param readings the readings of all sensors
     * @param wantedDistance the distance that the robot keeps from the wall, metres
     * @param oldest moment that counts
     * @param time now, seconds
     */
    void test(InspectedSensor sensor, double[] readings, double wantedDistance, int oldest, double time) {
        MountedCone cone = sensor.cone();
        if (ApproachCheck.applies(cone)) {
            testFront(cone, ApproachCheck.expectedAhead(sensor), readings, oldest, time);
        }
        if (cone.looksDiagonally()
                && assessment.mayBeRight(sensor.index())
                && reckoning.odometer().v() > DRIVING) {
            double turnRate = reckoning.odometer().omega();
            testFront(
                    cone,
                    NearSurfaceCheck.expectedAhead(cone, sensor.measurements(), wantedDistance, turnRate),
                    readings,
                    oldest,
                    time);
        }
    }

    /**
     * Tests whether a front sensor that sees nothing misses a surface.
     *
     * @param by the cone of the sensor that predicts it
     * @param expected the distance ahead of that sensor at which it crosses the path, metres; infinite if there is none
     */
    private void testFront(MountedCone by, double expected, double[] readings, int oldest, double time) {
        if (expected == Reading.NOTHING) {
            return;
        }
        for (InspectedSensor front : sensors) {
            double due = expected + by.x() - front.cone().x();
            boolean blind = front.cone().looksAhead()
                    && assessment.isTrusted(front.index())
                    && readings[front.index()] >= front.cone().range()
                    && due + PredictedSurface.FARTHER < front.cone().range();
            if (blind) {
                PredictedSurface surface = PredictedSurface.ahead(reckoning, front.cone(), due);
                if (!isRefuted(surface, front, oldest)) {
                    missed[front.index()] = surface;
                    assessment.addMissedSurface(front.index(), time);
                }
            }
        }
    }

    /** Returns whether other sensors or the robot's body have found the place of the last missed surface free. */
    boolean isRefuted(InspectedSensor sensor, int oldest) {
        return isRefuted(missed[sensor.index()], sensor, oldest);
    }

    private boolean isRefuted(PredictedSurface surface, InspectedSensor sensor, int oldest) {
        int others = assessment.trusted() & ~sensor.bit() | 1 << sensors.length;
        return surface.isRefuted(grid, oldest, others);
    }
}
