package faultline.app.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Timing;
import faultline.engine.ControllerMode;
import faultline.engine.HeadlessRun;
import faultline.engine.RunResult;
import faultline.engine.Setup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
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
class VerdictsTest {

    private static final int TRIALS = 60;

    private final Random random = new Random(20_260_101);

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /**
     * Another size, track, speed, spin rate, motor, range and cone; all sensors look away from the centre, as they do on the usual robot.
     */
    private RobotSpec robot() {
        double scale = between(0.6, 1.6);
        double range = between(0.5, 1.4);
        double cone = Degrees.toRadians(between(4, 40));
        RobotSpec usual = Alignment.BASE.robot();
        List<SensorSpec> sensors = usual.sensors().stream()
                .map(sensor -> sensor.withSeat(sensor.seat().times(scale)).withRange(range).withCone(cone)).toList();
        return new RobotSpec(usual.length() * scale, usual.width() * scale, usual.track() * scale, between(0.1, 0.4),
                Degrees.toRadians(between(20, 90)),
                new MotorSpec(between(0, 0.12), usual.motor().speedConstant(), usual.motor().maxVoltage()), sensors);
    }

    /** A wall met at any slant. */
    private Alignment trial(Timing timing) {
        double distance = between(0.15, 0.35);
        double away = distance + between(0.3, 0.5);
        Pose start = new Pose(Alignment.WALL + between(-0.3, 0.3), Alignment.WALL - away, Math.PI / 2 + Degrees.toRadians(between(-75, 75)));
        double period = random.nextInt(1, 11) * Alignment.BASE.dt();
        Setup there = Variation.of(Alignment.BASE, new WallFollowing(distance, WallFollowing.DEFAULT.hand(), period, timing)).withStart(start);
        return new Alignment(Variation.of(there, robot()), 1);
    }

    @Test
    void equalReadingsEndParallelBesideAnyLongWall() {
        for (int i = 0; i < TRIALS; i++) {
            Alignment trial = trial(Timing.EQUAL_READINGS);
            double error = StrictMath.toDegrees(trial.run().orElseThrow().error());
            assertTrue(Math.abs(error) <= 0.3, () -> error + " degrees: " + trial);
        }
    }

    @Test
    void toTheLetterTheMotorsLagAndTheSamplingAreMissing() {
        for (int i = 0; i < TRIALS; i++) {
            Alignment trial = trial(Timing.RANGE);
            Alignment.Outcome outcome = trial.run().orElseThrow();
            double rate = trial.robot().turnRate();
            double expected = -rate * (trial.robot().motor().timeConstant() + trial.period() / 2);
            double off = StrictMath.toDegrees(Math.abs(outcome.error() - expected));
            assertTrue(off <= StrictMath.toDegrees(rate * trial.period() / 2) + 0.3, () -> off + " degrees off: " + trial);
        }
    }

    @Test
    void noiseTurnsTheRobotByAFewTenthsOfADegreeAMillimetre() {
        for (int i = 0; i < TRIALS; i++) {
            double noise = between(0.001, 0.012);
            Alignment usual = Alignment.usual(Timing.EQUAL_READINGS, i % 6);
            Alignment trial = new Alignment(noisy(usual.setup(), noise).withSeed(random.nextInt(1_000_000)), 1);
            double error = StrictMath.toDegrees(trial.run().orElseThrow().error());
            assertTrue(Math.abs(error) <= 0.1 + 300 * noise, () -> error + " degrees with noise of " + noise);
        }
    }

    @Test
    void aRoomIsFollowedThroughNoiseOfUpToAHundredthOfAMetreWithHalfOfItForAnError() {
        Setup room = Shipped.load("noisy-sensors.xml").setup();
        Obstacle cabinet = Variation.obstacle(room, "cabinet");
        for (int i = 0; i < TRIALS / 5; i++) {
            double noise = between(0.001, 0.01);
            Setup elsewhere = Variation.of(room, cabinet.at(new Pose(between(2, 4), 3.7, 0))).withSeed(random.nextInt(1_000_000));
            RunResult result = HeadlessRun.run(noisy(elsewhere, noise), ControllerMode.DIRECT, List.of());
            assertTrue(result.collision().isEmpty() && result.distanceRms().orElseThrow() < noise / 2, () -> noise + ": " + result);
        }
    }

    private static Setup noisy(Setup setup, double deviation) {
        RobotSpec robot = setup.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(new SensorSpec(sensor.id(), sensor.seat(), sensor.bearing(), sensor.range(), sensor.cone(), sensor.on(), deviation));
        }
        return Variation.of(setup, robot);
    }

    @Test
    void whatOtherSensorsSufferFromTheSpinOnDoesNotReachTheTimedTurn() {
        for (int i = 0; i < TRIALS / 3; i++) {
            Alignment trial = trial(i % 2 == 0 ? Timing.RANGE : Timing.EQUAL_READINGS);
            double spin = Journey.of(trial.setup().withDuration(10)).states().indexOf("TURN") * trial.setup().dt();
            List<SensorSpec> others = trial.robot().sensors().stream().filter(sensor -> !sensor.id().equals("left")).toList();
            FaultKind kind = FaultKind.values()[random.nextInt(FaultKind.values().length)];
            Command fault = new Command.InjectFault(others.get(random.nextInt(others.size())).id(), kind.fault(kind.usual()));
            Alignment failing = new Alignment(Variation.of(trial.setup(), List.of(new Setup.Timed(spin, fault))), 1);
            assertEquals(Double.doubleToRawLongBits(trial.run().orElseThrow().tD()),
                    Double.doubleToRawLongBits(failing.run().orElseThrow().tD()), fault.toString());
        }
    }

    @Test
    void twoSensorsSufficeAboutTheRightAngleAndFourAtAny() {
        for (int i = 0; i < TRIALS / 3; i++) {
            double right = between(75, 105);
            double any = between(35, 150);
            assertTrue(Math.abs(CornerRun.error(CornerRun.of(right, CornerRun.Sensors.TWO))) <= 5, right + " degrees with two sensors");
            Journey four = CornerRun.of(any, CornerRun.Sensors.FOUR);
            assertTrue(four.result().collision().isEmpty(), any + " degrees with four");
            // A slight corner may be taken for a bend of the same wall, and is not timed then.
            assertTrue(!(Math.abs(CornerRun.error(four)) > 6), any + " degrees with four: " + CornerRun.error(four));
        }
    }

    @Test
    void anAcuteCornerIsMetTooNearWithoutTheFrontRightSensorAndAnObtuseOneWithoutTheFrontLeft() {
        for (int i = 0; i < TRIALS / 6; i++) {
            double acute = between(35, 65);
            double obtuse = between(115, 135);
            assertTrue(CornerRun.error(CornerRun.of(acute, CornerRun.Sensors.TWO)) < -10, acute + " degrees");
            assertTrue(Math.abs(CornerRun.error(CornerRun.of(acute, CornerRun.Sensors.FRONT_RIGHT))) <= 6, acute + " degrees");
            assertTrue(CornerRun.error(CornerRun.of(obtuse, CornerRun.Sensors.TWO)) < -10, obtuse + " degrees");
        }
    }

    @Test
    void aGlossyWallIsRunIntoOnlyWhereNoForwardConeComesNearItsNormal() {
        Setup base = Shipped.load("studies/glossy-wall.xml").setup();
        Obstacle wall = Variation.obstacle(base, "wall");
        double half = StrictMath.toDegrees(SensorSpec.DEFAULT_CONE) / 2;
        for (int i = 0; i < TRIALS; i++) {
            double slant = between(-60, 60);
            double specular = between(1, 30);
            // Well inside the lines of the map; at them it is a matter of a degree.
            boolean seen = IntStream.of(-45, 0, 45).anyMatch(bearing -> Math.abs(slant - bearing) < half + specular - 4);
            Obstacle glossy = new Obstacle(wall.id(), wall.shape(), wall.pose(), wall.motion(), Degrees.toRadians(specular));
            Pose start = new Pose(10 + between(-1, 1), 10 - between(0.9, 1.2), Math.PI / 2 + Degrees.toRadians(slant));
            boolean hit = Journey.of(Variation.of(base, glossy).withStart(start)).result().collision().isPresent();
            assertTrue(!(seen && hit), () -> "slant " + slant + ", specular " + specular);
        }
    }
}
