package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.sensor.SignalFault;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/**
 * Noise and faults of sensors and motors, and the points of a contact. The robot stands at (2, 2) and looks along x; a
 * desk whose near side is at x = 2.625 stands ahead of its front sensor, which is mounted at x = 2.125.
 */
class WorldReadingsTest {

    private static final int FRONT = 0;
    private static final int TICKS = 4000;
    private static final double NOISE = 0.05;

    private static final Optional<String> SUCCESS = Optional.empty();

    private static World room(double wall) {
        Obstacle desk = new Obstacle("desk", new ObstacleShape.RectangleShape(0.5, 0.5), new Pose(wall + 0.25, 2, 0));
        return new World(new WorldSpec(6, 4, true, 1, List.of(desk)), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 9);
    }

    private static Optional<String> refusal(World world, Command command) {
        return world.execute(command).refusal().map(refusal -> refusal.reason().name());
    }

    private static SensorSpec front(World world) {
        return world.robot().sensors().get(FRONT);
    }

    /** Returns the reported readings of the front sensor of a robot that stands. */
    private static double[] readings(World world) {
        double[] readings = new double[TICKS];
        for (int i = 0; i < TICKS; i++) {
            world.move(0, 0);
            world.sense();
            readings[i] = world.reportedReading(FRONT);
        }
        return readings;
    }

    private static double mean(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    @Test
    void noiseHasTheStatedDeviationAboutTheTrueReading() {
        World world = room(2.625);
        world.execute(new Command.ConfigureSensor(front(world).withNoise(NOISE)));
        double[] readings = readings(world);
        double mean = mean(readings);
        double squares = 0;
        for (double reading : readings) {
            squares += (reading - mean) * (reading - mean);
        }
        // Five standard errors of 4000 readings.
        assertEquals(0.5, mean, 0.004);
        assertEquals(NOISE, Math.sqrt(squares / TICKS), 0.0028);
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void noiseNeverLeavesTheRangeOfReadings() {
        World world = room(2.625);
        world.execute(new Command.ConfigureSensor(front(world).withNoise(NOISE).withRange(0.5)));
        int nothing = 0;
        for (double reading : readings(world)) {
            assertTrue(reading <= 0.5 || reading == Reading.NOTHING, () -> reading + " m");
            nothing += reading == Reading.NOTHING ? 1 : 0;
        }
        assertEquals(0.5, (double) nothing / TICKS, 0.04);
        World close = room(2.135);
        close.execute(new Command.ConfigureSensor(front(close).withNoise(NOISE)));
        int zero = 0;
        for (double reading : readings(close)) {
            assertTrue(reading >= 0, () -> reading + " m");
            zero += reading == 0 ? 1 : 0;
        }
        // The true reading is a fifth of the deviation: 42 % of the readings would be negative.
        assertEquals(0.42, (double) zero / TICKS, 0.04);
    }

    @Test
    void aFaultActsUntilItIsCleared() {
        World world = room(2.625);
        Fault bias = new Fault.Bias(0.2);
        assertEquals(SUCCESS, refusal(world, new Command.InjectFault("front", bias)));
        world.move(0, 0);
        world.sense();
        assertEquals(0.7, world.reportedReading(FRONT), 1e-12);
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
        assertEquals(SUCCESS, refusal(world, new Command.ClearFault("front", bias)));
        world.move(0, 0);
        world.sense();
        assertEquals(0.5, world.reportedReading(FRONT), 1e-12);
        assertEquals(Optional.of("UNKNOWN_FAULT"), refusal(world, new Command.ClearFault("front", bias)));
    }

    /** The window reads the sensors again after an edit while the run is paused. */
    @Test
    void readingsBetweenTwoTicksShowAnEditAndChangeNoLaterReading() {
        World edited = room(2.625);
        World untouched = room(2.625);
        for (World world : List.of(edited, untouched)) {
            world.execute(new Command.ConfigureSensor(front(world).withNoise(NOISE)));
            world.execute(new Command.InjectFault("front", new SignalFault.Delayed(0.02)));
        }
        for (int tick = 0; tick < 20; tick++) {
            for (World world : List.of(edited, untouched)) {
                world.move(0, 0);
                world.sense();
            }
            assertEquals(untouched.reportedReading(FRONT), edited.reportedReading(FRONT), "tick " + tick);
            edited.execute(new Command.MoveObstacle("desk", new Pose(3.075, 2, 0)));
            edited.resample();
            assertEquals(0.7, edited.trueReading(FRONT), 1e-12);
            edited.execute(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0)));
        }
    }

    @Test
    void aSensorStuckBeforeItsFirstReadingReportsNothing() {
        World world = room(2.625);
        world.execute(new Command.InjectFault("front", new SignalFault.StuckAtLast()));
        world.sense();
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
        assertEquals(Reading.NOTHING, world.reportedReading(FRONT));
    }

    @Test
    void theCopyOfTheReportedReadingsIsWhatEachSensorReports() {
        World world = room(2.625);
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.move(0, 0);
        world.sense();
        double[] copy = new double[world.robot().sensors().size()];
        world.copyReportedReadings(copy);
        for (int i = 0; i < copy.length; i++) {
            assertEquals(world.reportedReading(i), copy[i]);
        }
        assertEquals(0.7, copy[FRONT], 1e-12);
    }

    private static double headingAfterDriving(World world) {
        for (int i = 0; i < 30; i++) {
            world.move(2, 2);
        }
        return world.pose().heading();
    }

    @Test
    void aDeadMotorTurnsTheRobotToItsSideUntilItIsCleared() {
        World sound = room(4);
        assertEquals(0, headingAfterDriving(sound));
        for (MotorSide side : MotorSide.values()) {
            World world = room(4);
            MotorFault dead = new MotorFault.NoDrive();
            assertEquals(SUCCESS, refusal(world, new Command.InjectMotorFault(side, dead)));
            assertEquals(List.of(dead), world.motorFaults().of(side));
            double heading = headingAfterDriving(world);
            assertTrue(side == MotorSide.LEFT ? heading > 0.05 : heading < -0.05, side + ": " + heading);
        }
    }

    @Test
    void faultsOfMotorsAreClearedOneByOneOrAllAtOnceAndRestored() {
        World world = room(4);
        MotorFault weak = new MotorFault.Weak(0.5);
        MotorFault dead = new MotorFault.NoDrive();
        world.execute(new Command.InjectMotorFault(MotorSide.RIGHT, weak));
        world.execute(new Command.InjectMotorFault(MotorSide.RIGHT, dead));
        assertEquals(SUCCESS, refusal(world, new Command.ClearMotorFault(MotorSide.RIGHT, weak)));
        assertEquals(List.of(dead), world.motorFaults().of(MotorSide.RIGHT));
        assertEquals(
                Optional.of("UNKNOWN_MOTOR_FAULT"), refusal(world, new Command.ClearMotorFault(MotorSide.RIGHT, weak)));
        CommandResult cleared = world.execute(new Command.ClearMotorFaults(MotorSide.RIGHT));
        assertEquals(List.of(), world.motorFaults().of(MotorSide.RIGHT));
        assertEquals(List.of(), world.motorFaults().of(MotorSide.LEFT));
        cleared.inverse().forEach(world::execute);
        assertEquals(List.of(dead), world.motorFaults().of(MotorSide.RIGHT));
    }

    private static Collision drive(World world) {
        for (int i = 0; i < 1000 && world.collision().isEmpty(); i++) {
            world.move(3, 3);
        }
        return world.collision().orElseThrow();
    }

    @Test
    void aSideThatLiesFlushIsTouchedInItsMiddle() {
        Collision collision = drive(room(2.625));
        assertEquals("desk", collision.obstacle());
        assertEquals(0, collision.point().distanceTo(new Vector2(2.625, 2)), 1e-6);
    }

    @Test
    void aPostIsTouchedWhereItIsNearest() {
        World world = room(4);
        world.execute(new Command.PlaceObstacle(
                new Obstacle("post", new ObstacleShape.CircleShape(0.05), new Pose(2.6, 2.05, 0))));
        Collision collision = drive(world);
        assertEquals("post", collision.obstacle());
        assertEquals(0, collision.point().distanceTo(new Vector2(2.55, 2.05)), 1e-6);
        assertFalse(world.wheelSpeeds().left() > 0 || world.wheelSpeeds().right() > 0, "the robot stands");
    }

    @Test
    void aShortWallThatLiesFlushIsTouchedAtItsEnds() {
        World world = room(4);
        List<Vector2> ends = List.of(new Vector2(2.7, 1.98), new Vector2(2.7, 2.06));
        world.execute(new Command.PlaceObstacle(new Obstacle("board", new ObstacleShape.WallShape(ends), Pose.ORIGIN)));
        Collision collision = drive(world);
        assertEquals("board", collision.obstacle());
        assertEquals(0, collision.point().distanceTo(new Vector2(2.7, 2.02)), 1e-6);
        List<Vector2> contacts = world.snapshot().contacts();
        assertEquals(2, contacts.size());
        ends.forEach(
                end -> assertTrue(contacts.stream().anyMatch(point -> point.distanceTo(end) < 1e-8), end::toString));
    }

    @Test
    void ofTwoObstaclesThatAreTouchedAtOnceTheFirstIsNamed() {
        for (List<String> ids : List.of(List.of("one", "two"), List.of("two", "one"))) {
            World world = room(4);
            for (int i = 0; i < 2; i++) {
                double y = ids.get(i).equals("one") ? 2.05 : 1.95;
                world.execute(new Command.PlaceObstacle(
                        new Obstacle(ids.get(i), new ObstacleShape.CircleShape(0.04), new Pose(2.6, y, 0))));
            }
            assertEquals(ids.get(0), drive(world).obstacle());
        }
    }

    @Test
    void aListOfTheReportedReadingsAndOfTheFaultsIsThatOfTheSensors() {
        World world = room(2.625);
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.sense();
        double[] readings = world.reportedReadings();
        assertEquals(world.robot().sensors().size(), readings.length);
        assertEquals(0.7, readings[FRONT], 1e-12);
        assertEquals(List.of(new Fault.Bias(0.2)), world.faults(FRONT));
        assertEquals(List.of(), world.faults(FRONT + 1));
    }

    @Test
    void onlyCommandsChangeTheFaultsAndAListThatWasReadStaysAsItWas() {
        World world = room(2.625);
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        List<Fault> before = world.faults(FRONT);
        assertThrows(UnsupportedOperationException.class, before::clear);
        world.execute(new Command.ClearFaults("front"));
        assertEquals(List.of(), world.faults(FRONT));
        assertEquals(List.of(new Fault.Bias(0.2)), before);
    }

    @Test
    void aFaultActsOnTheReadingWithItsNoise() {
        World world = room(2.625);
        world.execute(new Command.ConfigureSensor(front(world).withNoise(NOISE)));
        World biased = room(2.625);
        biased.execute(new Command.ConfigureSensor(front(biased).withNoise(NOISE)));
        biased.execute(new Command.InjectFault("front", new Fault.Bias(0.1)));
        double[] plain = readings(world);
        double[] shifted = readings(biased);
        for (int i = 0; i < TICKS; i++) {
            assertEquals(plain[i] + 0.1, shifted[i], 1e-12, "the same noise, then the fault");
        }
    }

    @Test
    void aSensorBesideTheBodyReadsZeroInsideASolidObstacleOnly() {
        World world = room(2.625);
        world.execute(new Command.ConfigureSensor(front(world).withMountPosition(new Vector2(0.8, 0))));
        world.sense();
        assertEquals(0, world.trueReading(FRONT));
        world.execute(new Command.ConfigureSensor(front(world).withMountPosition(new Vector2(0.5, 0))));
        world.sense();
        assertEquals(0.125, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void theEnclosureIsTouchedWithBothCorners() {
        World world = new World(new WorldSpec(3, 4, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 9);
        assertEquals(WorldSpec.ENCLOSURE, drive(world).obstacle());
        List<Vector2> contacts = world.snapshot().contacts();
        assertEquals(2, contacts.size());
        for (Vector2 corner : List.of(new Vector2(3, 1.9), new Vector2(3, 2.1))) {
            assertTrue(contacts.stream().anyMatch(point -> point.distanceTo(corner) < 1e-6), contacts::toString);
        }
    }
}
