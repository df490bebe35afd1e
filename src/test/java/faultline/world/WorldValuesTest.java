package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Tests obstacles, paths and commands as values: a change affects only one property, and invalid values are refused.
 */
class WorldValuesTest {

    private static final ObstacleShape SQUARE = new ObstacleShape.RectangleShape(1, 1);
    private static final ObstacleShape ROUND = new ObstacleShape.CircleShape(1);
    private static final WaypointPath PATH = new WaypointPath(0.5, true, List.of(new Vector2(1, 2)));
    private static final Obstacle DESK = new Obstacle("desk", SQUARE, new Pose(1, 2, 3), PATH, 0.5);

    private static void assertRefused(Runnable creation) {
        assertThrows(IllegalArgumentException.class, creation::run);
    }

    @Test
    void aChangedObstacleKeepsTheRest() {
        assertEquals(new Obstacle("box", SQUARE, new Pose(1, 2, 3), PATH, 0.5), DESK.withId("box"));
        ObstacleShape wide = new ObstacleShape.RectangleShape(2, 1);
        assertEquals(new Obstacle("desk", wide, new Pose(1, 2, 3), PATH, 0.5), DESK.withShape(wide));
        assertEquals(new Obstacle("desk", SQUARE, Pose.ORIGIN, PATH, 0.5), DESK.withPose(Pose.ORIGIN));
        Obstacle standing = DESK.withMotion(WaypointPath.NONE);
        assertEquals(new Obstacle("desk", SQUARE, new Pose(1, 2, 3), WaypointPath.NONE, 0.5), standing);
        assertTrue(DESK.isMoving() && !standing.isMoving());
        Obstacle matt = DESK.withSpecularAngle(Obstacle.MATT);
        assertEquals(new Obstacle("desk", SQUARE, new Pose(1, 2, 3), PATH), matt);
        assertTrue(DESK.isSpecular() && !matt.isSpecular());
        assertEquals(new WaypointPath(0.5, true, List.of(Vector2.ZERO)), PATH.withWaypoints(List.of(Vector2.ZERO)));
    }

    @Test
    void anObstacleThatCannotBeIsRefused() {
        assertRefused(() -> DESK.withId(""));
        assertRefused(() -> DESK.withSpecularAngle(0));
        assertRefused(() -> DESK.withSpecularAngle(Math.nextUp(Obstacle.MATT)));
        assertRefused(() -> DESK.withShape(ROUND));
        assertRefused(() -> DESK.withShape(new ObstacleShape.EllipseShape(1, 2)));
        assertEquals(
                ROUND, DESK.withSpecularAngle(Obstacle.MATT).withShape(ROUND).shape());
    }

    @Test
    void aShapeNeedsPositiveFiniteLengthsAndEnoughPoints() {
        for (double wrong : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertRefused(() -> new ObstacleShape.RectangleShape(wrong, 1));
            assertRefused(() -> new ObstacleShape.RectangleShape(1, wrong));
            assertRefused(() -> new ObstacleShape.CircleShape(wrong));
            assertRefused(() -> new ObstacleShape.EllipseShape(wrong, 1));
            assertRefused(() -> new ObstacleShape.EllipseShape(1, wrong));
        }
        List<Vector2> two = List.of(Vector2.ZERO, new Vector2(1, 0));
        assertEquals(two, new ObstacleShape.WallShape(two).points());
        assertRefused(() -> new ObstacleShape.WallShape(two.subList(0, 1)));
        assertRefused(() -> new ObstacleShape.WallShape(List.of(Vector2.ZERO, new Vector2(Double.NaN, 0))));
        assertRefused(() -> new ObstacleShape.PolygonShape(two));
        assertRefused(() -> new ObstacleShape.PlanShape(List.of()));
        assertRefused(() -> new ObstacleShape.PlanShape(List.of(two)));
    }

    @Test
    void aPathNeedsWaypointsAndASpeedThatIsNotNegative() {
        assertRefused(() -> new WaypointPath(-0.1, false, List.of(Vector2.ZERO)));
        assertRefused(() -> new WaypointPath(0.1, false, List.of()));
        assertRefused(() -> new WaypointPath(0, true, List.of()));
        assertRefused(() -> PATH.withWaypoints(List.of(new Vector2(0, Double.NaN))));
        assertEquals(0, PATH.withSpeed(0).speed());
    }

    @Test
    void aWorldHasASizeDifferentIdsAndNoMoreMoversThanItAllows() {
        WorldSpec world = new WorldSpec(6, 4, true, 1, List.of(DESK));
        assertEquals(new WorldSpec(6, 4, true, 1, List.of()), world.withObstacles(List.of()));
        assertRefused(() -> new WorldSpec(0, 4, true, 1, List.of()));
        assertRefused(() -> new WorldSpec(6, Double.NaN, true, 1, List.of()));
        assertRefused(() -> world.withObstacles(List.of(DESK, DESK.withMotion(WaypointPath.NONE))));
        assertRefused(() -> world.withObstacles(List.of(DESK, DESK.withId("box"))));
        assertRefused(() -> world.withObstacles(List.of(DESK.withId(WorldSpec.ENCLOSURE))));
    }

    /** Names the commands that belong to a time of the run, and those that change the setup. */
    private static final Command.CommandCases<String> KINDS = Command.CommandCases.ofSetup(
            timed -> "timed",
            configureSensor -> "sensor",
            moveObstacle -> "move",
            placeObstacle -> "place",
            removeObstacle -> "remove",
            setPlatform -> "platform",
            configureController -> "controller");

    @Test
    void commandsOfATimeAreMatchedAlikeAndTheOthersByTheirKind() {
        SensorSpec front = RobotSpec.DEFAULT.sensors().get(0);
        List<Command> timed = List.of(
                new Command.SwitchSensor("front", false),
                new Command.InjectFault("front", new Fault.Dead()),
                new Command.ClearFault("front", new Fault.Dead()),
                new Command.ClearFaults("front"),
                new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.NoDrive()),
                new Command.ClearMotorFault(MotorSide.LEFT, new MotorFault.NoDrive()),
                new Command.ClearMotorFaults(MotorSide.LEFT));
        timed.forEach(command -> assertEquals("timed", command.match(KINDS)));
        List<Command> others = List.of(
                new Command.ConfigureSensor(front),
                new Command.MoveObstacle("desk", Pose.ORIGIN),
                new Command.PlaceObstacle(DESK),
                new Command.RemoveObstacle("desk"),
                new Command.SetPlatform(1, 1, 1),
                new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT));
        assertEquals(
                List.of("sensor", "move", "place", "remove", "platform", "controller"),
                others.stream().map(command -> command.match(KINDS)).toList());
    }

    @Test
    void aCommandAboutSomethingElseLeavesTheRobotAsItIs() {
        RobotSpec robot = RobotSpec.DEFAULT;
        assertEquals(robot, new Command.RemoveObstacle("desk").appliedTo(robot));
        assertEquals(robot, new Command.SwitchSensor("nose", false).appliedTo(robot));
        assertFalse(new Command.SwitchSensor("front", false)
                .appliedTo(robot)
                .sensors()
                .get(0)
                .on());
        SensorSpec nose = robot.sensors().get(0).withRange(0.1);
        assertEquals(robot.withSensor(nose), new Command.ConfigureSensor(nose).appliedTo(robot));
        assertEquals(robot.withPlatform(1, 2, 3), new Command.SetPlatform(1, 2, 3).appliedTo(robot));
    }

    @Test
    void theVelocityOfASnapshotIsThatOverTheTrueTrack() {
        RobotSpec robot = RobotSpec.DEFAULT.withDriveScale(new DriveScale(1, 1, 2));
        World world = new World(new WorldSpec(6, 4, true, 1, List.of()), robot, new Pose(2, 2, 0.3), 0.01, 1);
        assertEquals(new Pose(2, 2, 0.3), world.pose());
        world.move(2, 3);
        Snapshot snapshot = world.snapshot();
        double left = snapshot.wheelSpeeds().left();
        double right = snapshot.wheelSpeeds().right();
        assertEquals((left + right) / 2, snapshot.velocity().linear(), 1e-15);
        assertEquals((right - left) / (2 * robot.track()), snapshot.velocity().angular(), 1e-15);
        assertTrue(left > 0 && right > left);
    }
}
