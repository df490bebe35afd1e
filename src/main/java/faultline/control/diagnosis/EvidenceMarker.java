package faultline.control.diagnosis;

import faultline.control.diagnosis.EvidenceGrid.RowParity;
import java.util.Arrays;

/**
 * Adds what the sensors measure to the evidence grid. As long as nothing is suspicious, a measurement is added only if
 * that takes little time, or after some motion.
 */
final class EvidenceMarker {

    /** A sector is free up to this far before the reading, metres. */
    private static final double FREE_MARGIN = 0.04;

    /**
     * As long as nothing is suspicious, a measurement is added to the grid after the sensor's cone has moved sideways
     * by this, metres.
     */
    private static final double MARKING = 0.05;

    /**
     * A sector of less than this radius takes little time to mark. As long as nothing is suspicious, the free-space
     * evidence of sensors that look away from the path and the wall extends up to this distance only, metres.
     */
    private static final double NEAR = 0.5;

    /**
     * The bearings of sensors that look ahead or to the wall's side, radians: up to AHEAD on either side, and from
     * BESIDE to BACK on that of the wall. They matter most; the evidence of others is added less often.
     */
    private static final double AHEAD = StrictMath.toRadians(60);

    private static final double BESIDE = StrictMath.toRadians(30);
    private static final double BACK = StrictMath.toRadians(150);

    private final EvidenceGrid grid;
    private final ArcCheck arcCheck;
    private final TrustAssessment assessment;
    private final DeadReckoning reckoning;
    private final MotionClock clock;
    private final EvidenceSchedule[] schedules;
    private double bodyMarkedDistance = Double.NEGATIVE_INFINITY;
    private boolean alert;
    private int weight;

    /** What was added of one sensor, and where the robot was then. */
    static final class EvidenceSchedule {

        /** The share of the robot's motion by which the cone of a sensor that looks away counts as moved. */
        private static final double AWAY = 0.35;

        /** A turn moves a cone sideways at this distance from the robot, metres. */
        private static final double TURN_RADIUS = 0.24;

        private double markedDistance = Double.NEGATIVE_INFINITY;
        private double markedTurning;
        private int markedCount;
        private RowParity rows = RowParity.ODD;

        /** Returns how far the sensor's cone has moved sideways since its evidence was last added, metres. */
        double moved(MountedCone cone, DeadReckoning reckoning) {
            double sideways = looksAway(cone) ? AWAY : 1;
            return sideways * (reckoning.distance() - markedDistance)
                    + TURN_RADIUS * (reckoning.turning() - markedTurning);
        }

        /**
         * Records that a measurement is added.
         *
         * @param reckoning the robot's pose
         * @param count the number of measurements so far
         * @return the number of measurements that it represents
         */
        int mark(DeadReckoning reckoning, int count) {
            markedDistance = reckoning.distance();
            markedTurning = reckoning.turning();
            int passed = count - markedCount;
            markedCount = count;
            return passed;
        }

        /** Returns the rows to mark next if every second row is marked. */
        RowParity nextRows() {
            rows = rows == RowParity.EVEN ? RowParity.ODD : RowParity.EVEN;
            return rows;
        }
    }

    /**
     * Creates a marker that has added nothing yet.
     *
     * @param sensors the number of sensors
     * @param grid to which it adds evidence; the source after all sensors is the robot's body
     * @param arcCheck the test of measured arcs
     * @param assessment to which it adds confirmations
     * @param reckoning the robot's pose
     * @param clock the motion clock
     */
    EvidenceMarker(
            int sensors,
            EvidenceGrid grid,
            ArcCheck arcCheck,
            TrustAssessment assessment,
            DeadReckoning reckoning,
            MotionClock clock) {
        this.grid = grid;
        this.arcCheck = arcCheck;
        this.assessment = assessment;
        this.reckoning = reckoning;
        this.clock = clock;
        this.schedules = new EvidenceSchedule[sensors];
        Arrays.setAll(schedules, i -> new EvidenceSchedule());
    }

    /** Returns whether a sensor looks neither ahead nor to the wall's side. */
    static boolean looksAway(MountedCone cone) {
        return Math.abs(cone.bearing()) > AHEAD && cone.bearing() < BESIDE || cone.bearing() > BACK;
    }

    /**
     * Begins an inspection of all sensors.
     *
     * @param suspicious whether something is suspicious, so that all measurements are added at once
     * @param interval the weight of each measurement
     */
    void begin(boolean suspicious, int interval) {
        alert = suspicious;
        weight = interval;
    }

    /**
     * Adds the last measurement of a sensor: at once if that takes little time, otherwise after some motion.
     *
     * @param sensor the sensor that measured
     * @param sees whether it sees something
     * @param free the distance up to which it sees nothing, metres
     */
    void add(InspectedSensor sensor, boolean sees, double free) {
        EvidenceSchedule schedule = schedules[sensor.index()];
        boolean due = alert || schedule.moved(sensor.cone(), reckoning) > MARKING;
        double radius = free - FREE_MARGIN;
        boolean small = radius < NEAR;
        if (due) {
            int passed = schedule.mark(reckoning, sensor.measurements().count());
            if (sees && isConfirmed(sensor)) {
                assessment.addConfirmation(sensor.index(), passed * weight);
            }
        }
        if (radius > 0 && (due || small)) {
            boolean near = looksAway(sensor.cone()) && !alert;
            markFree(
                    sensor,
                    near ? Math.min(radius, NEAR) : radius,
                    alert || small || !sensor.cone().looksAside() ? RowParity.ALL : schedule.nextRows());
        }
    }

    private boolean isConfirmed(InspectedSensor sensor) {
        int now = clock.moment();
        return arcCheck.confirm(sensor, now, now - SensorInspection.MEMORY, assessment.trusted() & ~sensor.bit());
    }

    private void markFree(InspectedSensor sensor, double radius, RowParity rows) {
        MeasurementRing ring = sensor.measurements();
        grid.markSector(
                sensor.index(),
                ring.x(0),
                ring.y(0),
                ring.axisCos(0),
                ring.axisSin(0),
                sensor.table(),
                radius,
                clock.moment(),
                rows);
    }

    /**
     * Adds the place of the robot's body, which is free.
     *
     * @param radius the radius of the disc that it covers, metres
     */
    void addBody(double radius) {
        if (alert || reckoning.distance() - bodyMarkedDistance > MARKING) {
            bodyMarkedDistance = reckoning.distance();
            grid.markDisc(schedules.length, reckoning.x(), reckoning.y(), radius, clock.moment());
        }
    }
}
