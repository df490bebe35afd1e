package faultline.control.diagnosis;

import faultline.control.Observation;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * Diagnoses the sensors. Each tick it updates the robot's pose by dead reckoning and tests the signal of each sensor.
 * Checks that compare what the sensors measure with each other are made less often.
 */
public final class SensorDiagnosis {

    /**
     * The maximum number of sensors that are diagnosed, because each has a bit of an {@code int} and the robot's body
     * has another one. If there are more, the last ones in the robot's list are always trusted. They have no part in
     * the map of what the sensors saw.
     */
    public static final int MAX_SENSORS = Integer.SIZE - 1;

    private final WallSide side;
    private final DeadReckoning reckoning = new DeadReckoning();
    private final MotionClock clock = new MotionClock();
    private final MotionAccumulator motion = new MotionAccumulator();
    private RobotSpec robot;
    private InspectedSensor[] sensors = {};
    /** The tests of the sensors' signals in the same order. */
    private SignalCheck[] signals = {};
    /** The cones of the robot's other sensors, which are not diagnosed. */
    private MountedCone[] otherCones = {};
    /** The readings of the newest observation. */
    private double[] readings = {};

    private EvidenceGrid grid;
    private SensorInspection inspection;
    private TrustAssessment assessment;
    private WallComparison wallComparison;
    /** All checks that are not made at every tick, in their order. */
    private PacedCheck[] checks = {};

    private HealthReport report;
    private long tick;
    private double wantedDistance = Double.POSITIVE_INFINITY;
    private ToDoubleFunction<RobotSpec> centreDistance = anyRobot -> 0;
    private EvidenceReach reach = EvidenceReach.LEAST;

    /**
     * Creates a diagnosis with all sensors healthy.
     *
     * @param side the side of the wall
     */
    public SensorDiagnosis(WallSide side) {
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
        clock.advance(reckoning.rolled(), reckoning.turned(), dt);
        if (clock.restartAtEnd()) {
            grid.clear();
        }
        motion.advance(reckoning.rolled(), reckoning.turned(), dt);
        readings = observation.readings();
        testSignals();
        // Each check is called through its superclass, so that the compiler keeps the code of rare checks apart from
        // that of every tick.
        for (PacedCheck check : checks) {
            if (check.isDue(motion)) {
                check.run(readings, tick);
            }
        }
    }

    private void refit(RobotSpec newRobot) {
        List<SensorSpec> mounted = newRobot.sensors();
        int n = Math.min(mounted.size(), MAX_SENSORS);
        boolean same =
                robot != null && robot.sensors().size() == newRobot.sensors().size();
        robot = newRobot;
        if (!same) {
            sensors = new InspectedSensor[n];
            signals = new SignalCheck[n];
        }
        for (int i = 0; i < n; i++) {
            MountedCone cone = MountedCone.of(mounted.get(i), side);
            if (!same || !cone.equals(sensors[i].cone())) {
                // What was learnt about the signal of another cone does not hold for this one.
                signals[i] = new SignalCheck(cone, motion);
            }
            if (same) {
                sensors[i].refit(cone);
            } else {
                sensors[i] = new InspectedSensor(i, cone);
            }
        }
        otherCones = mounted.stream()
                .skip(n)
                .map(sensor -> MountedCone.of(sensor, side))
                .toArray(MountedCone[]::new);
        if (!same) {
            makeChecks();
        }
        updateReach();
        wallComparison.refit(new WallLine(sensors));
        inspection.refit(robot.width() / 2);
    }

    private void makeChecks() {
        grid = new EvidenceGrid(sensors.length + 1);
        report = new HealthReport(robot);
        assessment = new TrustAssessment(sensors.length);
        inspection = new SensorInspection(sensors, assessment, grid, reckoning, clock, motion, report);
        inspection.setWantedDistance(wantedDistance);
        reach = EvidenceReach.LEAST;
        JumpCheck jumpCheck = new JumpCheck(motion, assessment, inspection);
        wallComparison = new WallComparison(motion, reckoning, assessment, inspection, jumpCheck);
        checks = sensors.length == 0
                ? new PacedCheck[0]
                : new PacedCheck[] {
                    wallComparison, jumpCheck, new SpinComparison(sensors, reckoning, assessment), inspection
                };
    }

    private void testSignals() {
        for (int i = 0; i < signals.length; i++) {
            double reading = readings[i];
            SignalCheck signal = signals[i];
            if (signal.continues(reading)) {
                continue;
            }
            SensorFinding finding = signal.test(reading);
            if (signal.jumped()) {
                assessment.addJump(i, motion.time());
                wallComparison.jump(sensors[i]);
            }
            if (finding != SensorFinding.NONE) {
                distrust(i, finding);
            }
        }
    }

    private void distrust(int sensor, SensorFinding finding) {
        assessment.distrust(sensor, finding, motion.time());
        report.update(sensor, assessment, tick);
    }

    /**
     * Records a place that no sensor could see. It counts as a surface until it is seen free.
     *
     * @param x metres
     * @param y metres
     */
    public void markUnseen(double x, double y) {
        grid.markHit(sensors.length, EvidenceGrid.cellOf(x), EvidenceGrid.cellOf(y), clock.moment());
    }

    /**
     * Sets the distance from the wall that the robot keeps, which is the nearest that surfaces come.
     *
     * @param metres the distance, in metres
     * @param fromCentre the distance from a robot's centre to that wall, in metres
     */
    public void setWantedDistance(double metres, ToDoubleFunction<RobotSpec> fromCentre) {
        wantedDistance = metres;
        centreDistance = fromCentre;
        if (inspection != null) {
            inspection.setWantedDistance(metres);
            updateReach();
        }
    }

    /** Collects evidence as far as the wanted distance needs; what was collected before a change is forgotten. */
    private void updateReach() {
        EvidenceReach needed = EvidenceReach.of(centreDistance.applyAsDouble(robot));
        if (!needed.equals(reach)) {
            reach = needed;
            grid.resize(reach.gridSize());
            inspection.setReach(reach);
        }
    }

    /** {@return how far from the robot evidence is collected} */
    public EvidenceReach reach() {
        return reach;
    }

    /**
     * Records that the robot makes no progress if it steers by a sensor. One that is not diagnosed remains trusted.
     *
     * @param sensor its place in the robot's list
     */
    public void distrustMisleading(int sensor) {
        if (sensor < sensors.length) {
            distrust(sensor, SensorFinding.MISLEADING);
        }
    }

    /**
     * Trusts the sensors again that gave no answer and have answered for some time since, 3 s at first. For a robot at
     * rest, whose sensors cannot confirm each other: they see the same places all the time.
     */
    public void trustAnswering() {
        for (int i = 0; i < sensors.length; i++) {
            if (assessment.trustIfAnswering(i, motion.time())) {
                report.update(i, assessment, tick);
            }
        }
    }

    /** {@return whether a sensor has been found blind just now, because it misses a surface ahead of the robot} */
    public boolean hasMissedSurface() {
        return assessment.hasFoundBlind(motion.time());
    }

    /** {@return the number of sensors that are diagnosed} */
    public int sensors() {
        return sensors.length;
    }

    /** {@return the number of all sensors of the robot, diagnosed or not} */
    public int allSensors() {
        return sensors.length + otherCones.length;
    }

    /**
     * {@return whether a sensor answered the last time; it is off otherwise}
     *
     * @param sensor its place in the robot's list
     */
    public boolean answers(int sensor) {
        return !Reading.isOff(readings[sensor]);
    }

    /**
     * Returns whether a sensor is trusted.
     *
     * @param sensor its place in the robot's list
     * @return whether it is; false if there is a finding
     */
    public boolean isTrusted(int sensor) {
        return sensor >= sensors.length || assessment.isTrusted(sensor);
    }

    /** {@return whether all diagnosed sensors are trusted} */
    public boolean allTrusted() {
        return assessment.allTrusted();
    }

    /**
     * Returns the trusted sensors.
     *
     * @return a bit for each by its place in the robot's list
     */
    public int trusted() {
        return assessment.trusted();
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
        return sensor < sensors.length ? sensors[sensor].cone() : otherCones[sensor - sensors.length];
    }
}
