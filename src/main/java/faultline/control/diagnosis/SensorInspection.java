package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.Comparator;

/**
 * Inspects all sensors together: adds what they measure to the evidence grid and tests their measurements against it. A
 * surface must lie somewhere on the arc at the measured distance, so other trusted sensors, or the sensor itself,
 * cannot recently have seen all of that arc free.
 */
final class SensorInspection extends PacedCheck {

    /** The time between two inspections at the full rate, as a multiple of the number of sensors, seconds. */
    private static final double STEP = 0.01;

    /** The time for which free-space evidence counts in a test, on the motion clock. */
    static final int MEMORY = 700;

    /** The time for which a contradiction is suspicious, seconds. */
    private static final double SUSPICION = 1;

    /**
     * The time after a jump of a reading, or a drift, during which the rate of a straight path is not used, seconds.
     */
    private static final double ATTENTION = 0.5;

    /** A robot that turns faster than this does not drive straight on, radians per second. */
    private static final double TURNING = 0.5;

    /** A surface this near to a sensor that looks diagonally ahead may cross the path, metres. */
    private static final double CLOSE = 0.2;

    private final InspectedSensor[] sensors;
    private final TrustAssessment assessment;
    private final DeadReckoning reckoning;
    private final MotionClock clock;
    private final MotionAccumulator motion;
    private final HealthReport report;
    private final ArcCheck arcCheck;
    private final EvidenceMarker marker;
    private final MissedSurfaces missedSurfaces;
    /** The sensors in the order in which they are inspected. */
    private InspectedSensor[] inOrder = {};
    /** The indices of those that look diagonally ahead. */
    private int[] diagonal = {};

    private boolean alert;
    private InspectionRate rate = InspectionRate.FULL;
    /** When the next inspection is due, seconds. */
    private double due;

    private double attentionUntil = Double.NEGATIVE_INFINITY;
    /** What sensors measure farther than this from the robot's centre is not used, metres. */
    private double maxDistance = EvidenceReach.LEAST.distance();

    private double bodyRadius;
    private double wantedDistance = Double.POSITIVE_INFINITY;

    /**
     * Creates an inspection.
     *
     * @param sensors all sensors in the robot's order
     * @param assessment the assessment of the sensors
     * @param grid the evidence
     * @param reckoning the robot's pose
     * @param clock the motion clock
     * @param motion the robot's motion
     * @param report the health of the sensors
     */
    SensorInspection(
            InspectedSensor[] sensors,
            TrustAssessment assessment,
            EvidenceGrid grid,
            DeadReckoning reckoning,
            MotionClock clock,
            MotionAccumulator motion,
            HealthReport report) {
        super(MotionAccumulator.Total.TIME);
        this.sensors = sensors;
        this.assessment = assessment;
        this.reckoning = reckoning;
        this.clock = clock;
        this.motion = motion;
        this.report = report;
        this.arcCheck = new ArcCheck(grid, sensors.length);
        this.marker = new EvidenceMarker(sensors.length, grid, arcCheck, assessment, reckoning, clock);
        this.missedSurfaces = new MissedSurfaces(sensors, assessment, grid, reckoning);
    }

    /**
     * Applies the settings of the sensors, before the first inspection and whenever they change.
     *
     * @param radius the radius of the disc that the robot's body covers, metres
     */
    void refit(double radius) {
        bodyRadius = Math.min(radius, EvidenceReach.LEAST.distance());
        inOrder = inOrder(sensors);
        diagonal = Arrays.stream(sensors)
                .filter(sensor -> sensor.cone().looksDiagonally())
                .mapToInt(InspectedSensor::index)
                .toArray();
    }

    /** Returns sensors in order of bearing, from the front towards the wall, so that both sides work alike. */
    private static InspectedSensor[] inOrder(InspectedSensor[] sensors) {
        return Arrays.stream(sensors)
                .sorted(Comparator.comparingDouble(sensor -> {
                    double bearing = sensor.cone().bearing();
                    return bearing < 0 ? bearing + 2 * StrictMath.PI : bearing;
                }))
                .toArray(InspectedSensor[]::new);
    }

    /** Sets the distance from the wall that the robot keeps, metres. */
    void setWantedDistance(double metres) {
        wantedDistance = metres;
    }

    /** Sets how far from the robot's centre measurements are used. */
    void setReach(EvidenceReach reach) {
        maxDistance = reach.distance();
    }

    /** Inspects all sensors. */
    @Override
    void run(double[] readings, long tick) {
        double time = motion.time();
        alert = isSuspicious(time);
        marker.begin(alert, rate.interval());
        for (InspectedSensor sensor : inOrder) {
            inspect(sensor, readings, time);
        }
        // After all of them, because the judgement of one sensor can restore the trust in another.
        for (InspectedSensor sensor : inOrder) {
            report.update(sensor.index(), assessment, tick);
        }
        marker.addBody(bodyRadius);
        rate = rateAfter(readings, time);
        waitFor(Math.max(time, due + STEP * sensors.length * rate.interval()));
    }

    /**
     * Makes the next inspection earlier and inspections more frequent for some time, because a reading on the wall's
     * side has jumped or drifts.
     */
    void attend() {
        attentionUntil = motion.time() + ATTENTION;
        hasten();
    }

    /** Makes the next inspection as early as at the full rate. */
    void hasten() {
        if (rate != InspectionRate.FULL) {
            rate = InspectionRate.FULL;
            waitFor(Math.min(due, motion.time() + STEP * sensors.length));
        }
    }

    private void waitFor(double time) {
        due = time;
        // The sum of many ticks is not exact.
        waitUntil(Double.NEGATIVE_INFINITY, due - STEP / 2);
    }

    private InspectionRate rateAfter(double[] readings, double time) {
        if (isSuspicious(time) || isClose(readings)) {
            return InspectionRate.FULL;
        }
        boolean reduced = time < attentionUntil || Math.abs(motion.turnRate()) > TURNING || mayMissSurface(readings);
        return reduced ? InspectionRate.REDUCED : InspectionRate.STRAIGHT;
    }

    /** Returns the rate until the next inspection. */
    InspectionRate rate() {
        return rate;
    }

    /** Returns whether a sensor is not trusted, or was contradicted a short time ago. */
    private boolean isSuspicious(double time) {
        return !assessment.allTrusted() || time - assessment.lastSuspicion() < SUSPICION;
    }

    /**
     * Returns whether the front sensor sees nothing but the diagonal one on the side away from the wall does: the rate
     * of its readings may show that a surface is ahead.
     */
    private boolean mayMissSurface(double[] readings) {
        boolean seen = false;
        boolean missed = false;
        for (InspectedSensor sensor : sensors) {
            MountedCone cone = sensor.cone();
            double reading = readings[sensor.index()];
            seen |= ApproachCheck.applies(cone) && reading < cone.range();
            missed |= cone.looksAhead() && reading >= cone.range();
        }
        return seen && missed;
    }

    /** Returns whether a surface that may cross the path is near. */
    boolean isClose(double[] readings) {
        for (int sensor : diagonal) {
            if (readings[sensor] < CLOSE) {
                return true;
            }
        }
        return false;
    }

    private void inspect(InspectedSensor sensor, double[] readings, double time) {
        double reading = readings[sensor.index()];
        if (!Reading.isOff(reading)) {
            double limit = sensor.cone().rangeWithin(maxDistance);
            boolean sees = reading < limit;
            addMeasurement(sensor, sees ? reading : -1);
            if (sees) {
                test(sensor, 0, clock.moment() - MEMORY);
            }
            marker.add(sensor, sees, Math.min(reading, limit));
            retest(sensor);
            if (sees) {
                missedSurfaces.test(sensor, readings, wantedDistance, clock.moment() - MEMORY, time);
            }
        }
        int index = sensor.index();
        assessment.fade(index, rate.fade());
        if (assessment.finding(index) == SensorFinding.BLIND
                && missedSurfaces.isRefuted(sensor, clock.moment() - MEMORY)) {
            assessment.restore(index, time);
        }
        assessment.assess(index, time);
    }

    private void addMeasurement(InspectedSensor sensor, double reading) {
        MountedCone cone = sensor.cone();
        double cos = reckoning.headingCos();
        double sin = reckoning.headingSin();
        sensor.measurements()
                .add(
                        reckoning.x() + cos * cone.x() - sin * cone.y(),
                        reckoning.y() + sin * cone.x() + cos * cone.y(),
                        reckoning.heading() + cone.bearing(),
                        sensor.table().axisCos(cos, sin),
                        sensor.table().axisSin(cos, sin),
                        reading,
                        clock.ticks());
    }

    private void retest(InspectedSensor sensor) {
        if (!alert) {
            retest(sensor, rate.retest(sensor.measurements().count() % InspectionRate.RETESTS));
            return;
        }
        for (int i = 0; i < InspectionRate.RETESTS; i++) {
            retest(sensor, rate.retest(i));
        }
    }

    private void retest(InspectedSensor sensor, int age) {
        MeasurementRing ring = sensor.measurements();
        if (ring.has(age) && ring.reading(age) >= 0) {
            double since = clock.ticks() - ring.clock(age);
            if (since > 1 && since < MEMORY) {
                test(sensor, age, (int) ring.clock(age) + 1);
            }
        }
    }

    /** Tests a measurement against the free-space evidence since a moment. */
    private void test(InspectedSensor sensor, int age, int oldest) {
        int by = arcCheck.contradicting(sensor, age, oldest, assessment.trusted() | sensor.bit());
        if (by != ArcCheck.POSSIBLE) {
            assessment.addContradiction(sensor.index(), by, rate.interval());
        }
    }
}
