package faultline.control.diagnosis;

import faultline.control.Observation;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.diagnosis.EvidenceGrid.RowParity;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Diagnoses the sensors. All are inspected together a few times a second: there must be a surface somewhere on the arc
 * at the reported distance, so other trusted sensors, or the sensor itself, cannot recently have seen all of that arc
 * free.
 */
public final class SensorDiagnosis {

    /** How long free space counts in a test, on the motion clock. */
    private static final int MEMORY = 700;

    /** A sector is free up to this far before the reading, metres. */
    private static final double FREE_MARGIN = 0.04;

    /** Each claim is tested again after these numbers of inspections, because more has been seen free by then. */
    private static final int[] RETESTS = {5, 12, 24};

    /**
     * As long as nothing is suspicious, a sensor's claim is marked after its cone has moved sideways by this, metres.
     */
    private static final double MARKING = 0.05;

    /**
     * A sector of less than this radius takes little time to mark. As long as nothing is suspicious, the free space of
     * sensors that look away from the path and the wall is marked up to this distance only, metres.
     */
    private static final double NEAR = 0.5;

    /** A contradiction is suspicious for this long, seconds. */
    private static final double SUSPICION = 1;

    /** The time between two inspections for each of the sensors, seconds. */
    private static final double STEP = 0.01;

    private static final double FADE = 0.97;

    private final double side;
    private final DeadReckoning reckoning = new DeadReckoning();
    private final CurvatureEstimate curvature = new CurvatureEstimate();
    private final WallAgreement agreement = new WallAgreement();
    private final MotionClock clock = new MotionClock();
    private final Motion motion = new Motion();
    private RobotSpec robot;
    private InspectedSensor[] sensors = {};
    /** The tests of the sensors' signals in the same order. */
    private SignalCheck[] signals = {};
    /** The sensors in the order in which they are inspected. */
    private InspectedSensor[] inspectionOrder = {};

    private WallLine wallLine;
    private EvidenceGrid grid;
    private ClaimCheck claimCheck;
    private Verdicts verdicts;
    private MissedSurfaces missedSurfaces;
    private HealthReport report;
    private double[] lastReadings = {};
    private long tick;
    private double time;
    private double untilInspection;
    private boolean alert;
    private double bodyMarkedWay = Double.NEGATIVE_INFINITY;
    private double wantedDistance = Double.POSITIVE_INFINITY;

    /**
     * Creates a diagnosis with all sensors healthy.
     *
     * @param side 1 if the wall is on the left, -1 if it is on the right
     */
    public SensorDiagnosis(double side) {
        this.side = side;
    }

    /**
     * Processes an observation.
     *
     * @param observation the newest
     * @param nearVolts the voltage on the motors on the wall's side since the last observation
     * @param farVolts the voltage on the others
     * @param ticks the number of ticks since the last observation
     */
    public void update(Observation observation, double nearVolts, double farVolts, long ticks) {
        if (observation.robot() != robot) {
            refit(observation.robot());
        }
        reckoning.advance(robot, nearVolts, farVolts, observation.dt(), ticks);
        double dt = ticks * observation.dt();
        tick = observation.tick();
        time += dt;
        clock.advance(reckoning.rolled(), reckoning.turned(), dt);
        lastReadings = observation.readings();
        testSignals();
        learnCurvature();
        untilInspection -= dt;
        while (untilInspection < STEP / 2 && sensors.length > 0) {
            inspectAll();
            untilInspection += STEP * sensors.length;
        }
    }

    /** Learns beside straight walls how much more the path bends than the motors say. */
    private void learnCurvature() {
        curvature.update(
                wallLine.distance(lastReadings),
                wallLine.sag(lastReadings),
                reckoning.rolled(),
                reckoning.turned() - curvature.curvature() * reckoning.rolled());
        reckoning.setCurvature(curvature.curvature());
    }

    private void inspectAll() {
        alert = !verdicts.allTrusted() || time - verdicts.lastSuspicion() < SUSPICION;
        compareBesideWall();
        for (InspectedSensor sensor : inspectionOrder) {
            inspect(sensor, lastReadings[sensor.index()]);
        }
        if (alert || reckoning.way() - bodyMarkedWay > MARKING) {
            bodyMarkedWay = reckoning.way();
            grid.markDisc(sensors.length, reckoning.x(), reckoning.y(), robot.width() / 2, clock.moment());
        }
    }

    private void compareBesideWall() {
        int differs = agreement.update(wallLine, lastReadings, motion.way(), motion.heading());
        if (differs != WallAgreement.NONE) {
            verdicts.blameDrift(wallLine.sensor(differs).index());
        }
    }

    private void refit(RobotSpec newRobot) {
        int n = newRobot.sensors().size();
        boolean same = robot != null && n == sensors.length;
        robot = newRobot;
        if (!same) {
            sensors = new InspectedSensor[n];
            signals = new SignalCheck[n];
            grid = new EvidenceGrid(n + 1);
            claimCheck = new ClaimCheck(grid);
            report = new HealthReport(newRobot);
        }
        for (int i = 0; i < n; i++) {
            MountedCone cone = MountedCone.of(newRobot.sensors().get(i), side);
            if (same) {
                sensors[i].refit(cone);
            } else {
                sensors[i] = new InspectedSensor(i, cone);
                signals[i] = new SignalCheck(cone, motion);
            }
        }
        inspectionOrder = inOrder(sensors);
        wallLine = new WallLine(sensors);
        verdicts = same ? verdicts : new Verdicts(sensors);
        missedSurfaces = new MissedSurfaces(sensors, verdicts, grid, reckoning);
    }

    /** Returns sensors in order of bearing from the front by way of the wall, so that both sides work alike. */
    private static InspectedSensor[] inOrder(InspectedSensor[] sensors) {
        return Arrays.stream(sensors)
                .sorted(Comparator.comparingDouble(sensor -> {
                    double bearing = sensor.cone().bearing();
                    return bearing < 0 ? bearing + 2 * StrictMath.PI : bearing;
                }))
                .toArray(InspectedSensor[]::new);
    }

    private void testSignals() {
        motion.advance(reckoning.rolled(), reckoning.turned());
        for (int i = 0; i < signals.length; i++) {
            SensorFinding finding = signals[i].test(lastReadings[i]);
            if (signals[i].jumped()) {
                sensors[i].jump(time);
            }
            if (finding != SensorFinding.NONE) {
                verdicts.distrust(sensors[i], finding, time);
                refreshReport(sensors[i]);
            }
        }
    }

    private void inspect(InspectedSensor sensor, double reading) {
        if (!Reading.isOff(reading)) {
            boolean sees = reading < sensor.cone().range();
            keepClaim(sensor, sees ? reading : -1);
            if (sees) {
                test(sensor, 0, clock.moment() - MEMORY);
            }
            mark(sensor, sees, reading);
            retest(sensor);
            if (sees) {
                missedSurfaces.test(sensor, lastReadings, wantedDistance, clock.moment() - MEMORY, time);
            }
        }
        verdicts.fade(sensor, FADE);
        if (sensor.finding() == SensorFinding.BLIND && missedSurfaces.isRefuted(sensor, clock.moment() - MEMORY)) {
            verdicts.acquit(sensor, time);
        }
        verdicts.judge(sensor, time);
        refreshReport(sensor);
    }

    private void keepClaim(InspectedSensor sensor, double reading) {
        MountedCone cone = sensor.cone();
        double cos = reckoning.headingCos();
        double sin = reckoning.headingSin();
        sensor.claims()
                .add(
                        reckoning.x() + cos * cone.x() - sin * cone.y(),
                        reckoning.y() + sin * cone.x() + cos * cone.y(),
                        reckoning.heading() + cone.bearing(),
                        sensor.table().axisCos(cos, sin),
                        sensor.table().axisSin(cos, sin),
                        reading,
                        clock.ticks());
    }

    /** Marks the last claim in the map: at once if that takes little time, otherwise after some motion. */
    private void mark(InspectedSensor sensor, boolean sees, double reading) {
        sensor.countInspection();
        boolean due = alert || sensor.movedSinceMark(reckoning) > MARKING;
        double radius = (sees ? reading : sensor.cone().range()) - FREE_MARGIN;
        boolean small = radius < NEAR;
        if (due) {
            int inspections = sensor.mark(reckoning);
            if (sees && isConfirmed(sensor)) {
                sensor.confirm(inspections);
            }
        }
        if (radius > 0 && (due || small)) {
            boolean near = sensor.looksAway() && !alert;
            markFree(
                    sensor,
                    near ? Math.min(radius, NEAR) : radius,
                    alert || small || !sensor.looksAside() ? RowParity.ALL : sensor.nextRows());
        }
    }

    private boolean isConfirmed(InspectedSensor sensor) {
        int now = clock.moment();
        return claimCheck.confirm(sensor, now, now - MEMORY, verdicts.trusted() & ~sensor.bit());
    }

    private void markFree(InspectedSensor sensor, double radius, RowParity rows) {
        ClaimRing ring = sensor.claims();
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

    private void retest(InspectedSensor sensor) {
        if (!alert) {
            retest(sensor, RETESTS[sensor.inspections() % RETESTS.length]);
            return;
        }
        for (int age : RETESTS) {
            retest(sensor, age);
        }
    }

    private void retest(InspectedSensor sensor, int age) {
        ClaimRing ring = sensor.claims();
        if (ring.has(age) && ring.reading(age) >= 0) {
            double since = clock.ticks() - ring.clock(age);
            if (since > 1 && since < MEMORY) {
                test(sensor, age, (int) ring.clock(age) + 1);
            }
        }
    }

    /** Tests a claim against what was seen free since a moment. */
    private void test(InspectedSensor sensor, int age, int oldest) {
        int by = claimCheck.contradicting(sensor, age, oldest, verdicts.trusted() | sensor.bit());
        if (by != ClaimCheck.POSSIBLE) {
            verdicts.blame(sensor.index(), by);
        }
    }

    private void refreshReport(InspectedSensor sensor) {
        report.update(sensor.index(), sensor.finding(), verdicts.evidence(sensor.index()), tick);
    }

    /**
     * Records a place that no sensor could see: it counts as a surface until it is seen free.
     *
     * @param x metres
     * @param y metres
     */
    public void doubt(double x, double y) {
        grid.markHit(sensors.length, EvidenceGrid.cellOf(x), EvidenceGrid.cellOf(y), clock.moment());
    }

    /**
     * Sets the distance from the wall that the robot keeps, which is the nearest that surfaces come.
     *
     * @param metres the distance, in metres
     */
    public void setWantedDistance(double metres) {
        wantedDistance = metres;
    }

    /**
     * Records that the robot makes no progress if it steers by a sensor.
     *
     * @param sensor its place in the robot's list
     */
    public void distrustMisleading(int sensor) {
        verdicts.distrust(sensors[sensor], SensorFinding.MISLEADING, time);
        refreshReport(sensors[sensor]);
    }

    /** {@return the number of the robot's sensors} */
    public int sensors() {
        return sensors.length;
    }

    /**
     * Returns whether a sensor is trusted.
     *
     * @param sensor its place in the robot's list
     * @return whether it is; false if there is a finding
     */
    public boolean isTrusted(int sensor) {
        return sensors[sensor].isTrusted();
    }

    /** {@return whether all sensors are trusted} */
    public boolean allTrusted() {
        return verdicts.allTrusted();
    }

    /**
     * Returns the trusted sensors.
     *
     * @return a bit for each by its place in the robot's list
     */
    public int trusted() {
        return verdicts.trusted();
    }

    /** {@return the health of all sensors, the same list as long as nothing has changed} */
    public List<SensorHealth> health() {
        return report == null ? List.of() : report.all();
    }

    /**
     * Returns the robot's pose by dead reckoning.
     *
     * @return the live pose
     */
    public DeadReckoning reckoning() {
        return reckoning;
    }

    /**
     * Returns the map of what the sensors saw.
     *
     * @return the live map
     */
    public EvidenceGrid grid() {
        return grid;
    }

    /** {@return the moment on the motion clock} */
    public int now() {
        return clock.moment();
    }

    /**
     * Returns the cone of a sensor in a frame in which the wall is on the left.
     *
     * @param sensor its place in the robot's list
     * @return the cone
     */
    public MountedCone cone(int sensor) {
        return sensors[sensor].cone();
    }
}
