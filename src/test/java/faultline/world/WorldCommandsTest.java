package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * What commands do to the world, and what they are refused for. The robot stands at (2, 2) and looks along x; a desk stands 1 m ahead of
 * its front.
 */
class WorldCommandsTest {

    private static final int FRONT = 0;
    private static final Obstacle DESK = new Obstacle("desk", new ObstacleShape.Rectangle(0.5, 0.5), new Pose(3.375, 2, 0));
    private static final Optional<String> DONE = Optional.empty();

    private World world;

    @BeforeEach
    void aRoomWithADesk() {
        world = new World(new WorldSpec(6, 4, true, 1, List.of(DESK)), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
    }

    @Test
    void aMovedObstacleIsSeenWhereItIs() {
        assertEquals(DONE, world.apply(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0))));
        world.sense();
        // The desk's near side is at 2.625, the front sensor's seat at 2.125.
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void whatAGlossyWallDoesNotSendBackIsNotCircledEither() {
        // The front cone of 20 degrees meets the desk's near side squarely, and that of a desk turned by 30 degrees at 20 to 40.
        double within = Degrees.toRadians(15);
        world.apply(new Command.PutObstacle(new Obstacle("desk", DESK.shape(), new Pose(2.875, 2, 0), Optional.empty(), within)));
        assertEquals(2, world.snapshot().sensors().get(FRONT).hits().size());
        world.apply(new Command.MoveObstacle("desk", new Pose(2.875, 2, Degrees.toRadians(30))));
        world.sense();
        assertEquals(Reading.NOTHING, world.trueReading(FRONT));
        assertEquals(List.of(), world.snapshot().sensors().get(FRONT).hits());
    }

    @Test
    void aSensorThatIsSwitchedOffReportsOffAndStillHasATruth() {
        world.apply(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0)));
        assertEquals(DONE, world.apply(new Command.SwitchSensor("front", false)));
        world.sense();
        assertTrue(Reading.isOff(world.reportedReading(FRONT)));
        assertEquals(0.5, world.trueReading(FRONT), 1e-12);
    }

    @Test
    void faultsActInTheOrderInWhichTheyCame() {
        world.apply(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.apply(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.sense();
        assertEquals(0.5, world.reportedReading(FRONT), 1e-12);
        world.apply(new Command.ClearFaults("front"));
        world.apply(new Command.InjectFault("front", new Fault.Bias(0.2)));
        world.apply(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.sense();
        assertEquals(0.3, world.reportedReading(FRONT), 1e-12);
    }

    @Test
    void nothingMendsADeadSensorButClearingItsFault() {
        world.apply(new Command.InjectFault("front", new Fault.Dead()));
        world.apply(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.sense();
        assertTrue(Reading.isOff(world.reportedReading(FRONT)));
        assertEquals(DONE, world.apply(new Command.ClearFault("front", new Fault.Dead())));
        world.sense();
        assertEquals(0.3, world.reportedReading(FRONT), 1e-12);
    }

    @Test
    void anObstacleLaidOnTheRobotIsSlidUntilItTouchesAndThatIsACollision() {
        assertEquals(DONE, world.apply(new Command.MoveObstacle("desk", new Pose(2, 2, 0))));
        Collision collision = world.collision().orElseThrow();
        assertEquals("desk", collision.obstacle());
        // The body's front is at 2.125; the middle of the 0.2 m wide flush contact is on the axis.
        assertEquals(2.125, collision.point().x(), 1e-9);
        assertEquals(2, collision.point().y(), 1e-9);
        assertEquals(2.375, world.snapshot().obstacles().get(0).pose().x(), 1e-9);
        assertEquals(0, collision.time());
    }

    @Test
    void anObstacleThatOverlapsAsSoonAsItIsTurnedIsRefused() {
        world.apply(new Command.PutObstacle(new Obstacle("beam", new ObstacleShape.Rectangle(0.1, 3.9), new Pose(2.3, 2, 0))));
        Optional<String> refusal = world.apply(new Command.MoveObstacle("beam", new Pose(2.3, 2, StrictMath.PI / 2)));
        assertEquals(Optional.of("beam cannot be put there: it would overlap the robot"), refusal);
        assertTrue(world.collision().isEmpty());
        assertEquals(0, world.snapshot().obstacles().get(1).pose().heading());
    }

    @Test
    void aCollisionKeepsTheFaultsAndSwitchesOfItsMoment() {
        world.apply(new Command.InjectFault("left", new Fault.Stuck(0.3)));
        world.apply(new Command.SwitchSensor("rear", false));
        world.apply(new Command.MoveObstacle("desk", new Pose(2, 2, 0)));
        world.apply(new Command.ClearFaults("left"));
        Collision collision = world.collision().orElseThrow();
        assertEquals(Map.of("left", List.of(new Fault.Stuck(0.3))), collision.faults());
        assertEquals(List.of("rear"), collision.off());
    }

    @Test
    void whatIsUnknownIsRefusedByName() {
        assertEquals(Optional.of("there is no obstacle sofa"), world.apply(new Command.MoveObstacle("sofa", Pose.ORIGIN)));
        assertEquals(Optional.of("there is no obstacle sofa"), world.apply(new Command.RemoveObstacle("sofa")));
        assertEquals(Optional.of("the robot has no sensor top"), world.apply(new Command.SwitchSensor("top", true)));
        assertEquals(Optional.of("front has no such fault"), world.apply(new Command.ClearFault("front", new Fault.Dead())));
    }

    @Test
    void noMoreObstaclesMayMoveThanTheWorldAllows() {
        Motion motion = new Motion(0.1, true, List.of(new Vec(1, 1), new Vec(5, 1)));
        Obstacle one = new Obstacle("one", new ObstacleShape.Circle(0.1), new Pose(1, 1, 0), Optional.of(motion));
        Obstacle two = new Obstacle("two", new ObstacleShape.Circle(0.1), new Pose(5, 1, 0), Optional.of(motion));
        assertEquals(DONE, world.apply(new Command.PutObstacle(one)));
        assertEquals(DONE, world.apply(new Command.PutObstacle(one)));
        assertEquals(Optional.of("at most 1 obstacles may move"), world.apply(new Command.PutObstacle(two)));
    }

    @Test
    void aPlatformGrowsOnlyWhereItHasRoom() {
        assertEquals(DONE, world.apply(new Command.SetPlatform(1, 0.5, 0.2)));
        assertEquals(1, world.robot().length());
        Optional<String> refusal = world.apply(new Command.SetPlatform(2.5, 0.5, 0.2));
        assertEquals(Optional.of("the robot has no room for that platform: it would overlap desk"), refusal);
        assertEquals(1, world.robot().length());
    }

    @Test
    void anObstacleThatIsTakenAwayIsNotSeen() {
        world.apply(new Command.MoveObstacle("desk", new Pose(2.875, 2, 0)));
        assertEquals(DONE, world.apply(new Command.RemoveObstacle("desk")));
        world.sense();
        assertFalse(Double.isFinite(world.trueReading(FRONT)));
    }

    /** Takes what it finds back and forth: a command, its undoing and the command again. */
    private void assertUndoneExactly(Command command) {
        Snapshot before = world.snapshot();
        List<Command> undo = world.undoing(command);
        assertEquals(DONE, world.apply(command));
        assertNotEquals(before, world.snapshot());
        undo.forEach(back -> assertEquals(DONE, world.apply(back)));
        assertEquals(before, world.snapshot());
    }

    @Test
    void everyCommandCanBeTakenBackExactly() {
        assertUndoneExactly(new Command.MoveObstacle("desk", new Pose(5, 3, 1)));
        assertUndoneExactly(new Command.PutObstacle(new Obstacle("desk", new ObstacleShape.Circle(0.1), new Pose(1, 3, 0))));
        assertUndoneExactly(new Command.PutObstacle(new Obstacle("lamp", new ObstacleShape.Circle(0.1), new Pose(1, 3, 0))));
        assertUndoneExactly(new Command.RemoveObstacle("desk"));
        assertUndoneExactly(new Command.SetPlatform(0.3, 0.2, 0.1));
        assertUndoneExactly(new Command.SwitchSensor("front", false));
        assertUndoneExactly(new Command.TuneSensor(RobotSpec.DEFAULT.sensors().get(FRONT).withRange(0.4)));
    }

    @Test
    void faultsComeBackInTheirOrder() {
        world.apply(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        world.apply(new Command.InjectFault("front", new Fault.Bias(0.2)));
        assertUndoneExactly(new Command.InjectFault("front", new Fault.Stuck(0.3)));
        assertUndoneExactly(new Command.ClearFault("front", new Fault.Stuck(0.3)));
        assertUndoneExactly(new Command.ClearFaults("front"));
    }

    @Test
    void whatIsUnknownHasNothingToTakeBack() {
        assertEquals(List.of(), world.undoing(new Command.MoveObstacle("sofa", new Pose(1, 3, 0))));
        assertEquals(List.of(), world.undoing(new Command.RemoveObstacle("sofa")));
        assertEquals(List.of(), world.undoing(new Command.SwitchSensor("nose", false)));
    }
}
