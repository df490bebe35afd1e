package faultline.control.diagnosis;

import faultline.control.Observation;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Judges the sensors. One sensor is inspected at each step: what it reports must lie somewhere on the arc at the
 * reported distance, and what other trusted sensors, or it itself, saw free of late cannot hold that arc.
 */
public final class SensorDiagnosis {

    /** How far back free space counts in a test, motion clock. */
    private static final int MEMORY = 700;

    /** A sector is free up to this much before the reading, metres. */
    private static final double FREE_MARGIN = 0.04;

    /** Each claim is tested again after these numbers of inspections, when more has been seen free. */
    private static final int[] RETESTS = {5, 12, 24};

    private static final double FADE = 0.97;
    private static final double THRESHOLD = 9;
    private static final double FORGIVEN = 0.5;
    private static final int CONFIRMATIONS = 12;
    private static final int MAX_STANDOFF = 25;

    /** A sensor that was found contradicted less than this time ago may have been the victim, seconds. */
    private static final double EXONERATION = 6;

    /** The motion clock: ticks per metre rolled, per radian turned and per second. */
    private static final double CLOCK_METRE = 1000;

    private static final double CLOCK_RADIAN = 100;
    private static final double CLOCK_SECOND = 10;
    private static final double CLOCK_START = 1_000_000;

    /** A distrusted sensor is tried again after this time, seconds; each relapse doubles it. */
    private static final double FIRST_PENANCE = 3;

    private static final double MAX_PENANCE = 48;

    private final double side;
    private final DeadReckoning reckoning = new DeadReckoning();
    private RobotSpec robot;
    private MountedCone[] cones = {};
    private SignalTest[] signals = {};
    private EvidenceGrid grid;
    private ConflictCounts conflicts;
    private ConeTable[] tables = {};
    private ClaimRing[] claims = {};
    private ClaimTest claimTest;
    private SensorFinding[] findings = {};
    private double[] since = {};
    private double[] penance = {};
    private double[] confirmations = {};
    private boolean[] wasDistrusted = {};
    private HealthReport report;
    private long tick;
    private int[] standoff = {};
    private double[] blindness = {};
    private double[] lastReadings = {};
    private int trusted;
    private int next;
    private double clock = CLOCK_START;
    private double time;

    /**
     * A diagnosis of all sensors as healthy.
     *
     * @param side 1 where the wall is kept on the left, -1 on the right
     */
    public SensorDiagnosis(double side) {
        this.side = side;
    }

    /**
     * Takes an observation.
     *
     * @param observation the newest
     * @param nearVolts what the motors on the wall's side were given since the last one
     * @param farVolts what the others were given
     * @param ticks how long ago the last one was
     */
    public void update(Observation observation, double nearVolts, double farVolts, long ticks) {
        if (observation.robot() != robot) {
            refit(observation.robot());
        }
        reckoning.advance(robot, nearVolts, farVolts, observation.dt(), ticks);
        double dt = ticks * observation.dt();
        tick = observation.tick();
        time += dt;
        clock += CLOCK_METRE * Math.abs(reckoning.rolled())
                + CLOCK_RADIAN * Math.abs(reckoning.turned())
                + CLOCK_SECOND * dt;
        double[] readings = observation.readings();
        lastReadings = readings;
        for (int i = 0; i < cones.length; i++) {
            SensorFinding finding = signals[i].test(readings[i], reckoning.rolled(), reckoning.turned());
            if (finding != SensorFinding.NONE) {
                distrust(i, finding);
                refreshHealth(i);
            }
        }
        long steps = Math.max(1, Math.min(cones.length, Math.round(dt / 0.01)));
        for (long i = 0; i < steps && cones.length > 0; i++) {
            inspect(next, readings[next]);
            next = (next + 1) % cones.length;
        }
        if (next == 0) {
            grid.markDisc(cones.length, reckoning.x(), reckoning.y(), robot.width() / 2, moment());
        }
    }

    private void refit(RobotSpec newRobot) {
        int n = newRobot.sensors().size();
        boolean same = robot != null && n == cones.length;
        robot = newRobot;
        cones = newRobot.sensors().stream()
                .map(sensor -> MountedCone.of(sensor, side))
                .toArray(MountedCone[]::new);
        tables = Arrays.stream(cones).map(ConeTable::new).toArray(ConeTable[]::new);
        if (same) {
            return;
        }
        signals = Arrays.stream(cones).map(SignalTest::new).toArray(SignalTest[]::new);
        grid = new EvidenceGrid(n + 1);
        conflicts = new ConflictCounts(n);
        claimTest = new ClaimTest(grid);
        claims = Stream.generate(ClaimRing::new).limit(n).toArray(ClaimRing[]::new);
        findings = new SensorFinding[n];
        Arrays.fill(findings, SensorFinding.NONE);
        since = new double[n];
        penance = new double[n];
        Arrays.fill(penance, FIRST_PENANCE);
        confirmations = new double[n];
        standoff = new int[n];
        wasDistrusted = new boolean[n];
        blindness = new double[n];
        Arrays.fill(blindness, -1);
        trusted = (1 << n) - 1;
        report = new HealthReport(newRobot);
    }

    private int moment() {
        return (int) clock;
    }

    private void inspect(int sensor, double reading) {
        if (!Reading.isOff(reading)) {
            boolean sees = reading < cones[sensor].range();
            keepClaim(sensor, sees ? reading : -1);
            if (sees) {
                test(sensor, 0, moment() - MEMORY);
                if (claimTest.confirm(
                        sensor,
                        tables[sensor],
                        claims[sensor],
                        moment(),
                        moment() - MEMORY,
                        trusted & ~(1 << sensor))) {
                    confirmations[sensor]++;
                }
            }
            markFree(sensor, (sees ? reading : cones[sensor].range()) - FREE_MARGIN);
            retest(sensor);
            if (sees && ApproachTest.applies(cones[sensor])) {
                testApproach(sensor);
            }
        }
        conflicts.fade(sensor, FADE);
        confirmations[sensor] *= FADE;
        judge(sensor);
        refreshHealth(sensor);
    }

    private void keepClaim(int sensor, double reading) {
        MountedCone cone = cones[sensor];
        double cos = reckoning.headingCos();
        double sin = reckoning.headingSin();
        claims[sensor].add(
                reckoning.x() + cos * cone.x() - sin * cone.y(),
                reckoning.y() + sin * cone.x() + cos * cone.y(),
                reckoning.heading() + cone.bearing(),
                tables[sensor].axisCos(cos, sin),
                tables[sensor].axisSin(cos, sin),
                reading,
                clock);
    }

    private void markFree(int sensor, double radius) {
        if (radius > 0) {
            ClaimRing ring = claims[sensor];
            grid.markSector(
                    sensor, ring.x(0), ring.y(0), ring.axisCos(0), ring.axisSin(0), tables[sensor], radius, moment());
        }
    }

    private void retest(int sensor) {
        ClaimRing ring = claims[sensor];
        for (int age : RETESTS) {
            if (ring.has(age) && ring.reading(age) >= 0) {
                double since = clock - ring.clock(age);
                if (since > 1 && since < MEMORY) {
                    test(sensor, age, (int) ring.clock(age) + 1);
                }
            }
        }
    }

    /** Tests a claim against what was seen free since a moment. */
    private void test(int sensor, int age, int oldest) {
        int by = claimTest.contradicting(tables[sensor], claims[sensor], age, oldest, trusted | 1 << sensor);
        if (by != ClaimTest.POSSIBLE) {
            blame(sensor, by);
        }
    }

    private void blame(int sensor, int all) {
        if (all == 0) {
            // No one sensor contradicts the whole claim, but together they do.
            conflicts.add(sensor, sensor, 0.5);
            return;
        }
        for (int rest = all; rest != 0; rest &= rest - 1) {
            conflicts.add(sensor, Integer.numberOfTrailingZeros(rest), 1);
        }
    }

    private void testApproach(int sensor) {
        double expected = ApproachTest.expectedAhead(cones[sensor], claims[sensor]);
        for (int front = 0; front < cones.length && expected < Reading.NOTHING; front++) {
            boolean blind = Math.abs(cones[front].bearing()) < cones[front].half()
                    && isTrusted(front)
                    && expected + cones[sensor].x() - cones[front].x() < cones[front].range() - 0.15
                    && lastReadings[front] > expected + cones[sensor].x() - cones[front].x() + 0.15;
            if (blind) {
                conflicts.add(front, front, 3);
                blindness[front] = time;
            }
        }
    }

    private void judge(int sensor) {
        double against = conflicts.against(sensor, trusted);
        if (isTrusted(sensor)) {
            standoff[sensor] = hasStandoff(sensor) ? standoff[sensor] + 1 : 0;
            if (against > THRESHOLD && isWorst(against) || standoff[sensor] > MAX_STANDOFF) {
                boolean own = conflicts.pair(sensor, sensor) > against / 2;
                boolean blind = own && time - blindness[sensor] < 0.5;
                distrust(
                        sensor,
                        blind ? SensorFinding.BLIND : own ? SensorFinding.INCONSISTENT : SensorFinding.CONTRADICTED);
                exonerate();
            }
        } else if (against < FORGIVEN
                && time - since[sensor] > penance[sensor]
                && confirmations[sensor] > CONFIRMATIONS) {
            trust(sensor);
        }
    }

    /** Returns whether a sensor and a better confirmed one contradict each other, and neither anyone else. */
    private boolean hasStandoff(int sensor) {
        for (int other = 0; other < cones.length; other++) {
            if (isTrusted(other)
                    && conflicts.isStandoff(sensor, other)
                    && confirmations[sensor] <= confirmations[other]) {
                return true;
            }
        }
        return false;
    }

    /** Trusts those again whom only sensors contradicted that are not trusted any more. */
    private void exonerate() {
        for (int i = 0; i < cones.length; i++) {
            if (findings[i] == SensorFinding.CONTRADICTED
                    && time - since[i] < EXONERATION
                    && conflicts.against(i, trusted) < FORGIVEN) {
                trust(i);
            }
        }
    }

    private boolean isWorst(double against) {
        for (int other = 0; other < cones.length; other++) {
            if (isTrusted(other) && conflicts.against(other, trusted) > against) {
                return false;
            }
        }
        return true;
    }

    private void distrust(int sensor, SensorFinding finding) {
        if (isTrusted(sensor)) {
            trusted &= ~(1 << sensor);
            findings[sensor] = finding;
            if (wasDistrusted[sensor]) {
                penance[sensor] = Math.min(MAX_PENANCE, 2 * penance[sensor]);
            }
            wasDistrusted[sensor] = true;
            standoff[sensor] = 0;
        }
        since[sensor] = time;
        confirmations[sensor] = 0;
    }

    private void trust(int sensor) {
        trusted |= 1 << sensor;
        findings[sensor] = SensorFinding.NONE;
        since[sensor] = time;
    }

    /**
     * Notes a place that no sensor could see: it is taken for a surface until it is seen free.
     *
     * @param x metres
     * @param y metres
     */
    public void doubt(double x, double y) {
        grid.markHit(cones.length, x, y, moment());
    }

    /** Returns how many sensors the robot has. */
    public int sensors() {
        return cones.length;
    }

    /**
     * Whether a sensor is trusted.
     *
     * @param sensor its place in the robot's list
     * @return false where there is a finding
     */
    public boolean isTrusted(int sensor) {
        return (trusted >> sensor & 1) != 0;
    }

    /**
     * The trusted sensors.
     *
     * @return a bit for each by its place in the robot's list
     */
    public int trusted() {
        return trusted;
    }

    /**
     * Why a sensor is not trusted.
     *
     * @param sensor its place in the robot's list
     * @return {@link SensorFinding#NONE} where it is
     */
    public SensorFinding finding(int sensor) {
        return findings[sensor];
    }

    /** Returns the findings and evidence for all sensors, the same list as long as nothing has changed. */
    public List<SensorHealth> health() {
        return report == null ? List.of() : report.all();
    }

    private void refreshHealth(int sensor) {
        report.update(sensor, findings[sensor], against(sensor) / THRESHOLD, tick);
    }

    /**
     * The count of contradictions against a sensor.
     *
     * @param sensor its place in the robot's list
     * @return 0 for none, beyond {@link #THRESHOLD} it is not trusted
     */
    public double against(int sensor) {
        return conflicts.against(sensor, trusted);
    }

    /**
     * Where the robot is by dead reckoning.
     *
     * @return the live pose
     */
    public DeadReckoning reckoning() {
        return reckoning;
    }

    /**
     * What the sensors saw.
     *
     * @return the live map
     */
    public EvidenceGrid grid() {
        return grid;
    }

    /**
     * The motion clock.
     *
     * @return now
     */
    public int now() {
        return moment();
    }

    /**
     * How the sensors are mounted in the frame in which the wall is kept on the left.
     *
     * @param sensor its place in the robot's list
     * @return the cone
     */
    public MountedCone cone(int sensor) {
        return cones[sensor];
    }
}
