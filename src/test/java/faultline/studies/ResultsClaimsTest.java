package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.TimingRule;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The verdicts of docs/results.md on robots and worlds that the studies do not have. */
class ResultsClaimsTest {

    private static final int TRIALS = 60;

    private final Random random = new Random(20_260_101);

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /**
     * Another size, track, speed, spin rate, motor, range and cone; all sensors look away from the centre, as they do
     * on the default robot.
     */
    private RobotSpec robot() {
        double scale = between(0.6, 1.6);
        double range = between(0.5, 1.4);
        double cone = Degrees.toRadians(between(4, 40));
        RobotSpec standard = AlignmentTrial.BASE.robot();
        List<SensorSpec> sensors = standard.sensors().stream()
                .map(sensor -> sensor.withMountPosition(sensor.mountPosition().times(scale))
                        .withRange(range)
                        .withCone(cone))
                .toList();
        return new RobotSpec(
                standard.length() * scale,
                standard.width() * scale,
                standard.track() * scale,
                between(0.1, 0.4),
                Degrees.toRadians(between(20, 90)),
                new MotorSpec(
                        between(0, 0.12),
                        standard.motor().speedConstant(),
                        standard.motor().maxVoltage()),
                DriveScale.NONE,
                sensors);
    }

    /** A wall met at any slant. */
    private AlignmentTrial trial(TimingRule timing) {
        double distance = between(0.15, 0.35);
        double away = distance + between(0.3, 0.5);
        Pose start = new Pose(
                AlignmentTrial.WALL_Y + between(-0.3, 0.3),
                AlignmentTrial.WALL_Y - away,
                Math.PI / 2 + Degrees.toRadians(between(-75, 75)));
        double period = random.nextInt(1, 11) * AlignmentTrial.BASE.dt();
        SimulationSetup there = AlignmentTrial.BASE
                .withController(WallFollowing.DEFAULT
                        .withDistance(distance)
                        .withPeriod(period)
                        .withTimingRule(timing)
                        .withDiagnosis(false))
                .withStart(start);
        return new AlignmentTrial(there.withRobot(robot()), 1);
    }

    @Test
    void equalReadingsEndParallelBesideAnyLongWall() {
        for (int i = 0; i < TRIALS; i++) {
            AlignmentTrial trial = trial(TimingRule.EQUAL_READINGS);
            double error = StrictMath.toDegrees(trial.run().orElseThrow().headingError());
            assertTrue(Math.abs(error) <= 0.3, () -> error + " degrees: " + trial);
        }
    }

    @Test
    void theRangeRuleMissesTheMotorLagAndTheSampling() {
        for (int i = 0; i < TRIALS; i++) {
            AlignmentTrial trial = trial(TimingRule.RANGE);
            AlignmentTrial.TrialResult outcome = trial.run().orElseThrow();
            double rate = trial.robot().turnRate();
            double expected = -rate * (trial.robot().motor().timeConstant() + trial.period() / 2);
            double off = StrictMath.toDegrees(Math.abs(outcome.headingError() - expected));
            assertTrue(
                    off <= StrictMath.toDegrees(rate * trial.period() / 2) + 0.3, () -> off + " degrees off: " + trial);
        }
    }

    @Test
    void noiseTurnsTheRobotByAFewTenthsOfADegreeAMillimetre() {
        for (int i = 0; i < TRIALS; i++) {
            double noise = between(0.001, 0.012);
            AlignmentTrial base = AlignmentTrial.standard(TimingRule.EQUAL_READINGS, i % 6);
            AlignmentTrial trial =
                    new AlignmentTrial(noisy(base.setup(), noise).withSeed(random.nextInt(1_000_000)), 1);
            double error = StrictMath.toDegrees(trial.run().orElseThrow().headingError());
            assertTrue(Math.abs(error) <= 0.1 + 300 * noise, () -> error + " degrees with noise of " + noise);
        }
    }

    @Test
    void aRoomIsFollowedThroughNoiseOfUpToAHundredthOfAMetreWithHalfOfItForAnError() {
        SimulationSetup room = StudyScenarios.load("noisy-sensors.xml").setup();
        Obstacle cabinet = SetupVariations.findObstacle(room, "cabinet");
        for (int i = 0; i < TRIALS / 5; i++) {
            double noise = between(0.001, 0.01);
            SimulationSetup elsewhere = SetupVariations.with(room, cabinet.withPose(new Pose(between(2, 4), 3.7, 0)))
                    .withSeed(random.nextInt(1_000_000));
            RunResult result = HeadlessRun.run(noisy(elsewhere, noise), ControllerMode.DIRECT, List.of());
            assertTrue(
                    result.collision().isEmpty() && result.distanceRms().orElseThrow() < noise / 2,
                    () -> noise + ": " + result);
        }
    }

    private static SimulationSetup noisy(SimulationSetup setup, double deviation) {
        RobotSpec robot = setup.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(new SensorSpec(
                    sensor.id(),
                    sensor.mountPosition(),
                    sensor.bearing(),
                    sensor.range(),
                    sensor.cone(),
                    sensor.on(),
                    deviation));
        }
        return setup.withRobot(robot);
    }

    @Test
    void whatOtherSensorsSufferFromTheSpinOnDoesNotReachTheTimedTurn() {
        for (int i = 0; i < TRIALS / 3; i++) {
            AlignmentTrial trial = trial(i % 2 == 0 ? TimingRule.RANGE : TimingRule.EQUAL_READINGS);
            double spin =
                    RunTrace.simulate(trial.setup().withDuration(10)).states().indexOf(FollowerState.TURN)
                            * trial.setup().dt();
            List<SensorSpec> others = trial.robot().sensors().stream()
                    .filter(sensor -> !sensor.id().equals("left"))
                    .toList();
            FaultKind kind = FaultKind.values()[random.nextInt(FaultKind.values().length)];
            Command fault = new Command.InjectFault(
                    others.get(random.nextInt(others.size())).id(), kind.createFault(kind.defaultValue()));
            AlignmentTrial failing = new AlignmentTrial(
                    trial.setup().withTimeline(List.of(new SimulationSetup.TimedCommand(spin, fault))), 1);
            assertEquals(
                    Double.doubleToRawLongBits(trial.run().orElseThrow().tD()),
                    Double.doubleToRawLongBits(failing.run().orElseThrow().tD()),
                    fault.toString());
        }
    }

    /**
     * Returns the distance error to the second wall when the robot has been aligned with it, millimetres; not a number
     * if it was not.
     */
    private static double distanceError(RunTrace trace) {
        List<Integer> handOvers = trace.handOvers();
        if (handOvers.size() < 2) {
            return Double.NaN;
        }
        int tick = handOvers.get(1);
        try (Simulation simulation = new Simulation(trace.setup(), ControllerMode.DIRECT)) {
            while (simulation.ticks() < tick) {
                simulation.tick();
            }
            double reading = simulation.trueReading(trace.setup().robot().indexOf("left"));
            return 1000 * (reading - WallFollowing.DEFAULT.distance());
        }
    }

    @Test
    void twoSensorsSufficeAboutTheRightAngleAndFourAtAny() {
        for (int i = 0; i < TRIALS / 3; i++) {
            double right = between(75, 105);
            double any = between(35, 150);
            assertTrue(
                    Math.abs(distanceError(CornerRun.run(right, CornerRun.SensorSelection.TWO))) <= 5,
                    right + " degrees with two sensors");
            RunTrace four = CornerRun.run(any, CornerRun.SensorSelection.FOUR);
            assertTrue(four.result().collision().isEmpty(), any + " degrees with four");
            // A slight corner may be treated as a bend of the same wall; then there is no spin to time.
            assertTrue(!(Math.abs(distanceError(four)) > 6), any + " degrees with four: " + distanceError(four));
        }
    }

    @Test
    void anAcuteCornerIsMetTooNearWithoutTheFrontRightSensorAndAnObtuseOneWithoutTheFrontLeft() {
        for (int i = 0; i < TRIALS / 6; i++) {
            double acute = between(35, 65);
            double obtuse = between(115, 135);
            assertTrue(distanceError(CornerRun.run(acute, CornerRun.SensorSelection.TWO)) < -10, acute + " degrees");
            assertTrue(
                    Math.abs(distanceError(CornerRun.run(acute, CornerRun.SensorSelection.FRONT_RIGHT))) <= 6,
                    acute + " degrees");
            assertTrue(distanceError(CornerRun.run(obtuse, CornerRun.SensorSelection.TWO)) < -10, obtuse + " degrees");
        }
    }

    @Test
    void aSpecularWallIsHitOnlyWhereNoForwardConeComesNearItsNormal() {
        SimulationSetup base = StudyScenarios.load("studies/glossy-wall.xml").setup();
        Obstacle wall = SetupVariations.findObstacle(base, "wall");
        double half = StrictMath.toDegrees(SensorSpec.DEFAULT_CONE) / 2;
        for (int i = 0; i < TRIALS; i++) {
            double slant = between(-60, 60);
            double specular = between(1, 30);
            // Well inside the lines of the map; at them it is a matter of a degree.
            boolean seen =
                    IntStream.of(-45, 0, 45).anyMatch(bearing -> Math.abs(slant - bearing) < half + specular - 4);
            Obstacle glossy = wall.withSpecularAngle(Degrees.toRadians(specular));
            Pose start = new Pose(10 + between(-1, 1), 10 - between(0.9, 1.2), Math.PI / 2 + Degrees.toRadians(slant));
            boolean hit = RunTrace.simulate(SetupVariations.with(base, glossy).withStart(start))
                    .result()
                    .collision()
                    .isPresent();
            assertTrue(!(seen && hit), () -> "slant " + slant + ", specular " + specular);
        }
    }
}
