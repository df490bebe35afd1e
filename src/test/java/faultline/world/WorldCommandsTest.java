package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.geometry.BoxDistance;
import faultline.geometry.Degrees;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * What commands do to the world, and what they are refused for. The robot stands at (2, 2) and looks along x; a desk
 * stands 1 m ahead of its front.
 */
class WorldCommandsTest {

    private static final int FRONT = 0;
    private static final Obstacle DESK =
            new Obstacle("desk", new ObstacleShape.RectangleShape(0.5, 0.5), new Pose(3.375, 2, 0));
    private static final Optional<String> SUCCESS = Optional.empty();

    private World world;

    @BeforeEach
    void createRoomWithDesk() {
        world = new World(new WorldSpec(6, 4, true, 1, List.of(DESK)), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
    }

    @Test
    void aMovedObstacleIsSeenWhereItIs() {
        assertEquals(SUCCESS, refusal(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0))));
        world.sense();
        // The desk's near side is at 2.625, the front sensor's mounting position at 2.125.
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void theListOfObstaclesIsMadeAgainOnlyAfterAnEdit() {
        List<Obstacle> before = world.snapshot().obstacles();
        assertSame(before, world.snapshot().obstacles());
        world.execute(new Command.MoveObstacle("desk", new Pose(3, 3, 0)));
        assertEquals(List.of(DESK.withPose(new Pose(3, 3, 0))), world.snapshot().obstacles());
        world.execute(new Command.RemoveObstacle("desk"));
        assertEquals(List.of(), world.snapshot().obstacles());
    }

    @Test
    void aSpecularWallIsCircledOnlyWhereItReflects() {
        // The front cone of 20 degrees meets the desk's near side squarely, and that of a desk turned by 30 degrees at
        // 20 to 40.
        double within = Degrees.toRadians(15);
        world.execute(new Command.PlaceObstacle(
                new Obstacle("desk", DESK.shape(), new Pose(2.875, 2, 0), WaypointPath.NONE, within)));
        assertEquals(2, world.snapshot().sensors().get(FRONT).intersections().size());
        world.execute(new Command.MoveObstacle("desk", new Pose(2.875, 2, Degrees.toRadians(30))));
        world.sense();
        assertEquals(Reading.NOTHING, world.trueReading(FRONT));
        assertEquals(List.of(), world.snapshot().sensors().get(FRONT).intersections());
    }

    @Test
    void aSensorThatIsSwitchedOffReportsOffAndStillHasATrueReading() {
        world.execute(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0)));
        assertEquals(SUCCESS, refusal(new Command.SwitchSensor("front", false)));
        world.sense();
        assertTrue(Reading.isOff(world.reportedReading(FRONT)));
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void faultsActInTheOrderInWhichTheyCame() {
        world.execute(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.sense();
        assertEquals(0.5, world.reportedReading(FRONT), 1e-12);
        world.execute(new Command.ClearFaults("front"));
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.execute(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.sense();
        assertEquals(0.3, world.reportedReading(FRONT), 1e-12);
    }

    @Test
    void onlyClearingItsFaultRestoresADeadSensor() {
        world.execute(new Command.InjectFault("front", new Fault.Dead()));
        world.execute(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.sense();
        assertTrue(Reading.isOff(world.reportedReading(FRONT)));
        assertEquals(SUCCESS, refusal(new Command.ClearFault("front", new Fault.Dead())));
        world.sense();
        assertEquals(0.3, world.reportedReading(FRONT), 1e-12);
    }

    @Test
    void anObstacleMovedOntoTheRobotSlidesUntilItTouchesAndThatIsACollision() {
        assertEquals(SUCCESS, refusal(new Command.MoveObstacle("desk", new Pose(2, 2, 0))));
        Collision collision = world.collision().orElseThrow();
        assertEquals("desk", collision.obstacle());
        // The body's front is at 2.125; the middle of the 0.2 m wide flush contact is on the axis.
        assertEquals(2.125, collision.point().x(), 1e-9);
        assertEquals(2, collision.point().y(), 1e-9);
        assertEquals(2.375, world.snapshot().obstacles().get(0).pose().x(), 1e-9);
        assertEquals(0, collision.time());
    }

    /** The first block slides over the robot, and the second one along it for more steps than there may be. */
    @Test
    void aSlideWhoseContactIsHiddenByRoundingEndsAtTheContact() {
        assertSlideEndsAtTheRobot(
                new Pose(5, 5, 0), 1, 2000, new Pose(5.625000003, 5, 0), new Pose(5.125000003, -495, 0));
        assertSlideEndsAtTheRobot(
                new Pose(8.2, 6.5, 0), 2300, 0.17, new Pose(8.6, 6.314999999, 0), new Pose(-492, 6.315002001, 0));
    }

    private static void assertSlideEndsAtTheRobot(Pose robot, double width, double height, Pose from, Pose to) {
        Obstacle block = new Obstacle("block", new ObstacleShape.RectangleShape(width, height), from);
        World world = new World(new WorldSpec(10, 10, false, 3, List.of(block)), RobotSpec.DEFAULT, robot, 0.01, 1);
        assertEquals(
                Optional.empty(),
                world.execute(new Command.MoveObstacle("block", to)).refusal());
        assertEquals("block", world.collision().orElseThrow().obstacle());
        Obstacle moved = world.snapshot().obstacles().get(0);
        OrientedBox body = new OrientedBox(robot, RobotSpec.DEFAULT.length(), RobotSpec.DEFAULT.width());
        double gap = ObstacleGeometry.of(moved).parts().stream()
                .mapToDouble(part -> BoxDistance.between(body, part).distance())
                .min()
                .orElseThrow();
        assertTrue(gap > 0 && gap < 1e-9, gap + " m beside " + moved);
    }

    @Test
    void anObstacleThatTouchesTheRobotComesBackWhenItsRemovalIsUndone() {
        for (double heading : List.of(0.0, 0.1, 0.7, 1.3, StrictMath.PI / 4)) {
            world.execute(new Command.PlaceObstacle(
                    new Obstacle("box", new ObstacleShape.RectangleShape(0.3, 0.2), new Pose(1, 1, heading))));
            assertEquals(SUCCESS, refusal(new Command.MoveObstacle("box", new Pose(2, 2, heading))));
            Obstacle touching = world.snapshot().obstacles().get(1);
            CommandResult.Executed removal = (CommandResult.Executed) world.execute(new Command.RemoveObstacle("box"));
            removal.inverse().forEach(command -> assertEquals(SUCCESS, refusal(command)));
            assertEquals(touching, world.snapshot().obstacles().get(1));
            world.execute(new Command.RemoveObstacle("box"));
        }
    }

    @Test
    void anObstacleThatTouchesTheRobotComesBackWhenItsMoveIsUndone() {
        for (double heading : List.of(0.0, 0.1, 0.7, 1.3, StrictMath.PI / 4)) {
            world.execute(new Command.PlaceObstacle(
                    new Obstacle("box", new ObstacleShape.RectangleShape(0.3, 0.2), new Pose(1, 1, heading))));
            assertEquals(SUCCESS, refusal(new Command.MoveObstacle("box", new Pose(2, 2, heading))));
            Obstacle touching = world.snapshot().obstacles().get(1);
            for (Pose away : List.of(new Pose(3, 2, heading), new Pose(2, 1, heading + 1), new Pose(1, 1, heading))) {
                CommandResult.Executed move =
                        (CommandResult.Executed) world.execute(new Command.MoveObstacle("box", away));
                move.inverse().forEach(command -> assertEquals(SUCCESS, refusal(command)));
                assertEquals(touching, world.snapshot().obstacles().get(1));
            }
            world.execute(new Command.RemoveObstacle("box"));
        }
    }

    @Test
    void anObstacleIsNotPutIntoTheRobot() {
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(0.25, 0.2), new Pose(2.25 - 1e-8, 2, 0));
        assertEquals(
                Optional.of("box cannot be put there: it would overlap the robot"),
                refusal(new Command.PlaceObstacle(box)));
        assertEquals(SUCCESS, refusal(new Command.PlaceObstacle(box.withPose(new Pose(2.25, 2, 0)))));
    }

    @Test
    void anObstacleThatOverlapsAsSoonAsItIsTurnedIsRefused() {
        world.execute(new Command.PlaceObstacle(
                new Obstacle("beam", new ObstacleShape.RectangleShape(0.1, 3.9), new Pose(2.3, 2, 0))));
        Optional<String> refusal = refusal(new Command.MoveObstacle("beam", new Pose(2.3, 2, StrictMath.PI / 2)));
        assertEquals(Optional.of("beam cannot be put there: it would overlap the robot"), refusal);
        assertTrue(world.collision().isEmpty());
        assertEquals(0, world.snapshot().obstacles().get(1).pose().heading());
    }

    @Test
    void aCollisionKeepsTheFaultsAndSwitchesOfItsMoment() {
        world.execute(new Command.InjectFault("left", new Fault.Stuck(0.3)));
        world.execute(new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.Weak(0.9)));
        world.execute(new Command.SwitchSensor("rear", false));
        world.execute(new Command.MoveObstacle("desk", new Pose(2, 2, 0)));
        world.execute(new Command.ClearFaults("left"));
        world.execute(new Command.ClearMotorFaults(MotorSide.LEFT));
        Collision collision = world.collision().orElseThrow();
        assertEquals(Map.of("left", List.of(new Fault.Stuck(0.3))), collision.faults());
        assertEquals(List.of("rear"), collision.switchedOff());
        assertEquals(new MotorFaults(List.of(new MotorFault.Weak(0.9)), List.of()), collision.motorFaults());
    }

    @Test
    void unknownIdsAreNamedInTheRefusal() {
        assertEquals(Optional.of("there is no obstacle sofa"), refusal(new Command.MoveObstacle("sofa", Pose.ORIGIN)));
        assertEquals(Optional.of("there is no obstacle sofa"), refusal(new Command.RemoveObstacle("sofa")));
        assertEquals(Optional.of("the robot has no sensor top"), refusal(new Command.SwitchSensor("top", true)));
        assertEquals(
                Optional.of("front has no such fault"), refusal(new Command.ClearFault("front", new Fault.Dead())));
    }

    @Test
    void noMoreObstaclesMayMoveThanTheWorldAllows() {
        WaypointPath motion = new WaypointPath(0.1, true, List.of(new Vector2(1, 1), new Vector2(5, 1)));
        Obstacle one = new Obstacle("one", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0), motion);
        Obstacle two = new Obstacle("two", new ObstacleShape.CircleShape(0.1), new Pose(5, 1, 0), motion);
        assertEquals(SUCCESS, refusal(new Command.PlaceObstacle(one)));
        assertEquals(SUCCESS, refusal(new Command.PlaceObstacle(one)));
        assertEquals(Optional.of("at most 1 obstacles may move"), refusal(new Command.PlaceObstacle(two)));
    }

    @Test
    void aPlatformGrowsOnlyWhereItHasRoom() {
        assertEquals(SUCCESS, refusal(new Command.SetPlatform(1, 0.5, 0.2)));
        assertEquals(1, world.robot().length());
        Optional<String> refusal = refusal(new Command.SetPlatform(2.5, 0.5, 0.2));
        assertEquals(Optional.of("the robot has no room for that platform: it would overlap desk"), refusal);
        assertEquals(1, world.robot().length());
    }

    @Test
    void aPlatformDoesNotGrowThroughTheWallsOfTheRoom() {
        assertEquals(
                Optional.of("the robot has no room for that platform: it would overlap " + WorldSpec.ENCLOSURE),
                refusal(new Command.SetPlatform(0.3, 4.1, 0.2)));
    }

    @Test
    void aPlatformThatHasGrownTouchesWhatItHadRoomBefore() {
        for (int i = 0; i < 10; i++) {
            world.move(2, 2);
        }
        double centre = world.pose().x();
        // The desk's near side is at 3.125.
        assertEquals(SUCCESS, refusal(new Command.SetPlatform(2 * (3.125 - 0.02 - centre), 0.2, 0.3)));
        for (int i = 0; i < 100 && world.collision().isEmpty(); i++) {
            world.move(2, 2);
        }
        assertEquals("desk", world.collision().orElseThrow().obstacle());
        assertEquals(centre + 0.02, world.pose().x(), 1e-6);
    }

    @Test
    void aMovingObstacleStopsWhereItTouchesTheRobot() {
        WaypointPath path = new WaypointPath(0.37, false, List.of(new Vector2(2.9, 2), new Vector2(1, 2)));
        world.execute(new Command.PlaceObstacle(
                new Obstacle("cart", new ObstacleShape.CircleShape(0.1), new Pose(2.9, 2, 0), path)));
        for (int i = 0; i < 1000 && world.collision().isEmpty(); i++) {
            world.move(0, 0);
        }
        assertEquals("cart", world.collision().orElseThrow().obstacle());
        assertEquals((2.9 - 2.225) / 0.37, world.collision().orElseThrow().time(), 1e-6);
        Obstacle cart = world.snapshot().obstacles().stream()
                .filter(Obstacle::isMoving)
                .findFirst()
                .orElseThrow();
        assertEquals(2.225, cart.pose().x(), 1e-6);
    }

    @Test
    void anObstacleThatIsTakenAwayIsNotSeen() {
        world.execute(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0)));
        assertEquals(SUCCESS, refusal(new Command.RemoveObstacle("desk")));
        world.sense();
        assertFalse(Double.isFinite(world.trueReading(FRONT)));
    }

    private Optional<String> refusal(Command command) {
        return world.execute(command).refusal().map(Refusal::message);
    }

    private List<Command> inverse(Command command) {
        return world.execute(command).inverse();
    }

    /** Executes a command and its inverse, which restores the world exactly. */
    private void assertInvertedExactly(Command command) {
        Snapshot before = world.snapshot();
        CommandResult result = world.execute(command);
        assertEquals(SUCCESS, result.refusal());
        assertNotEquals(before, world.snapshot());
        result.inverse().forEach(back -> assertEquals(SUCCESS, refusal(back)));
        assertEquals(before, world.snapshot());
    }

    @Test
    void everyCommandHasAnExactInverse() {
        assertInvertedExactly(new Command.MoveObstacle("desk", new Pose(5, 3, 1)));
        assertInvertedExactly(
                new Command.PlaceObstacle(new Obstacle("desk", new ObstacleShape.CircleShape(0.1), new Pose(1, 3, 0))));
        assertInvertedExactly(
                new Command.PlaceObstacle(new Obstacle("lamp", new ObstacleShape.CircleShape(0.1), new Pose(1, 3, 0))));
        assertInvertedExactly(new Command.RemoveObstacle("desk"));
        assertInvertedExactly(new Command.SetPlatform(0.3, 0.2, 0.1));
        assertInvertedExactly(new Command.SwitchSensor("front", false));
        assertInvertedExactly(new Command.ConfigureSensor(
                RobotSpec.DEFAULT.sensors().get(FRONT).withRange(0.4)));
    }

    @Test
    void faultsAreRestoredInTheirOrder() {
        world.execute(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.execute(new Command.InjectFault("front", new Fault.Bias(0.2)));
        assertInvertedExactly(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        assertInvertedExactly(new Command.ClearFault("front", new Fault.Stuck(0.3)));
        assertInvertedExactly(new Command.ClearFaults("front"));
    }

    @Test
    void aCommandThatChangesNothingSaysSo() {
        for (Command command : List.of(
                new Command.SwitchSensor("front", false),
                new Command.SetPlatform(0.2, 0.1, 0.2),
                new Command.MoveObstacle("desk", new Pose(1, 3, 0)))) {
            assertFalse(world.execute(command).isNoOp(), command.toString());
            assertTrue(world.execute(command).isNoOp(), command.toString());
        }
        assertTrue(world.execute(new Command.ClearFaults("front")).isNoOp());
        assertFalse(world.execute(new Command.SwitchSensor("nose", false)).isNoOp(), "refused");
    }

    @Test
    void refusedCommandsHaveNoInverse() {
        assertEquals(List.of(), inverse(new Command.MoveObstacle("sofa", new Pose(1, 3, 0))));
        assertEquals(List.of(), inverse(new Command.RemoveObstacle("sofa")));
        assertEquals(List.of(), inverse(new Command.SwitchSensor("nose", false)));
    }

    @Test
    void anObstacleIsNotPlacedOnTheRobotNorUnderTheNameOfTheEnclosure() {
        ObstacleShape shape = new ObstacleShape.CircleShape(0.1);
        assertEquals(
                Optional.of("lamp cannot be put there: it would overlap the robot"),
                refusal(new Command.PlaceObstacle(new Obstacle("lamp", shape, new Pose(2, 2.15, 0)))));
        CommandResult reserved =
                world.execute(new Command.PlaceObstacle(new Obstacle(WorldSpec.ENCLOSURE, shape, new Pose(1, 3, 0))));
        assertEquals(
                Refusal.Reason.RESERVED_ID, reserved.refusal().orElseThrow().reason());
        assertEquals(List.of(DESK), world.snapshot().obstacles());
    }

    /** A file must not have such a motion. */
    @Test
    void anObstacleIsNotPlacedThatIsTooFastForItsWaypoints() {
        Obstacle still = new Obstacle("lamp", new ObstacleShape.CircleShape(0.1), new Pose(1, 3, 0));
        List<Vector2> near = List.of(new Vector2(1, 3), new Vector2(1.0004, 3));
        assertEquals(
                Optional.of(
                        "lamp would be too fast for its waypoints: it must take 0.01 s or more to visit all of them"),
                refusal(new Command.PlaceObstacle(still.withMotion(new WaypointPath(0.1, true, near)))));
        assertEquals(
                Optional.empty(),
                refusal(new Command.PlaceObstacle(still.withMotion(new WaypointPath(0.1, false, near)))));
        assertEquals(
                Optional.empty(),
                refusal(new Command.PlaceObstacle(still.withMotion(new WaypointPath(0.05, true, near)))));
    }

    @Test
    void aPlatformMayShrinkWhereItTouches() {
        world.execute(new Command.SetPlatform(1, 0.5, 0.2));
        world.execute(new Command.MoveObstacle("desk", new Pose(2, 2, 0)));
        assertTrue(world.collision().isPresent());
        assertEquals(SUCCESS, refusal(new Command.SetPlatform(0.9, 0.5, 0.2)));
        assertEquals(SUCCESS, refusal(new Command.SetPlatform(0.9, 0.4, 0.2)));
        assertEquals(0.4, world.robot().width());
    }

    /** Otherwise it would collide at rest. */
    @Test
    void aPlatformDoesNotGrowUntilItTouches() {
        // The desk's near side is 1.125 m ahead of the robot's centre.
        assertEquals(
                Optional.of("the robot has no room for that platform: it would overlap desk"),
                refusal(new Command.SetPlatform(2.25, 0.2, 0.3)));
        assertEquals(SUCCESS, refusal(new Command.SetPlatform(2.25 - 2e-8, 0.2, 0.3)));
        world.move(-2, -2);
        assertTrue(world.collision().isEmpty());
    }

    @Test
    void aPlatformGetsItsSizeBackAfterACollision() {
        for (double heading : new double[] {0, 0.3, 2, 4}) {
            world = new World(
                    new WorldSpec(6, 4, true, 1, List.of(DESK)), RobotSpec.DEFAULT, new Pose(2, 2, heading), 0.01, 1);
            for (int i = 0; i < 2000 && world.collision().isEmpty(); i++) {
                world.move(3, 3);
            }
            assertTrue(world.collision().isPresent());
            assertInvertedExactly(new Command.SetPlatform(0.2, 0.15, 0.3));
        }
    }

    @Test
    void aPlatformDoesNotGrowInOneDirectionWhileItShrinksInTheOther() {
        world.execute(new Command.MoveObstacle("desk", new Pose(2, 2.4, 0)));
        Optional<String> overlap = Optional.of("the robot has no room for that platform: it would overlap desk");
        assertEquals(overlap, refusal(new Command.SetPlatform(0.2, 0.4, 0.2)));
        world.execute(new Command.MoveObstacle("desk", new Pose(2.5, 2, 0)));
        assertEquals(overlap, refusal(new Command.SetPlatform(0.6, 0.1, 0.2)));
    }

    @Test
    void aCommandIsRecordedForTheTickThatFollows() {
        Command off = new Command.SwitchSensor("front", false);
        assertEquals(0, world.execute(off).tick());
        world.sense();
        assertEquals(1, world.execute(off).tick());
        world.move(0, 0);
        world.sense();
        CommandResult result = world.execute(off);
        assertEquals(2, result.tick());
        assertEquals(off, result.command());
        assertEquals(1, world.tick());
        assertEquals(1, world.snapshot().tick());
        assertEquals(0.01, world.snapshot().time());
    }

    @Test
    void theSettingsOfTheControllerChangeNothingInTheWorld() {
        Snapshot before = world.snapshot();
        CommandResult result = world.execute(new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT));
        assertEquals(SUCCESS, result.refusal().map(Refusal::message));
        assertEquals(before, world.snapshot());
    }

    @Test
    void anObstacleMovedIntoTheRobotCollidesInTheTickOfItsCommand() {
        world.sense();
        world.move(0, 0);
        world.sense();
        CommandResult result = world.execute(new Command.MoveObstacle("desk", world.pose()));
        Collision collision = world.collision().orElseThrow();
        assertEquals(2, result.tick());
        assertEquals(2, collision.tick());
        assertEquals(0.01, collision.time());
    }

    @Test
    void aDriveIntoTheDeskIsRecordedWithItsTickAndTime() {
        for (int i = 0; i < 1000 && world.collision().isEmpty(); i++) {
            world.move(2, 2);
        }
        Collision collision = world.collision().orElseThrow();
        assertEquals(world.tick(), collision.tick());
        assertTrue(collision.time() > (collision.tick() - 1) * 0.01 && collision.time() <= collision.tick() * 0.01);
        assertEquals(Optional.of(collision), world.snapshot().collision());
        assertEquals(
                collision.point(),
                world.snapshot()
                        .contacts()
                        .get(0)
                        .plus(world.snapshot().contacts().get(1))
                        .times(0.5));
    }

    @Test
    void aRobotThatStandsSeesEachEditAtOnce() {
        Command near = new Command.MoveObstacle("desk", new Pose(2.875, 2, 0));
        double[] expected = {Reading.NOTHING, 0.5, Reading.NOTHING, 0.4};
        List<List<Command>> edits = List.of(
                List.of(),
                List.of(near),
                List.of(new Command.RemoveObstacle("desk")),
                List.of(new Command.PlaceObstacle(DESK.withPose(new Pose(2.775, 2, 0)))));
        for (int i = 0; i < expected.length; i++) {
            edits.get(i).forEach(world::execute);
            world.move(0, 0);
            world.sense();
            assertEquals(expected[i], world.trueReading(FRONT), 1e-12);
        }
    }
}
