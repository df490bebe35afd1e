package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Obstacles on their waypoints, and the robot in their way. */
class MovingObstaclesTest {

    private static final double TICK = 0.01;

    private static World world(Pose robot, Obstacle... obstacles) {
        return new World(new WorldSpec(6, 4, false, 3, List.of(obstacles)), RobotSpec.DEFAULT, robot, TICK, 1);
    }

    private static Obstacle visitor(double x, double y, double speed, boolean loop, Vector2... points) {
        WaypointPath motion = new WaypointPath(speed, loop, List.of(points));
        return new Obstacle("visitor", new ObstacleShape.CircleShape(0.1), new Pose(x, y, 0), motion);
    }

    private static Vector2 positionAfter(World world, double seconds) {
        long ticks = Math.round(seconds / TICK);
        for (long i = 0; i < ticks; i++) {
            world.move(0, 0);
        }
        return world.snapshot().obstacles().get(0).pose().position();
    }

    private static void assertAt(double x, double y, Vector2 point) {
        assertEquals(x, point.x(), 1e-9);
        assertEquals(y, point.y(), 1e-9);
    }

    @Test
    void itPassesTheWaypointsAtConstantSpeed() {
        World world = world(new Pose(5, 3.5, 0), visitor(0, 0, 0.5, false, new Vector2(1, 0), new Vector2(1, 1)));
        assertAt(0.5, 0, positionAfter(world, 1));
        assertAt(1, 0.5, positionAfter(world, 2));
    }

    /** Finding what is touched looks at all sides of a floor plan nearby. */
    @Test
    void onlyTheFirstContactOfOneThatPressesOnTheRobotIsFound() {
        ObstacleSet obstacles = new ObstacleSet(
                new WorldSpec(6, 4, false, 3, List.of(visitor(3, 2, 0.5, true, new Vector2(1, 2), new Vector2(3, 2)))));
        MotionStep step = new MotionStep(obstacles, new RobotBody(RobotSpec.DEFAULT, new Pose(2, 2, 0)));
        int contacts = 0;
        for (int i = 0; i < 1000; i++) {
            step.move(TICK);
            contacts += step.pollContact().isPresent() ? 1 : 0;
        }
        assertEquals(1, contacts);
        assertEquals(2.225, obstacles.moving().get(0).follower().x(), 1e-6);
    }

    @Test
    void aSpeedChangeKeepsTheNextWaypoint() {
        Obstacle visitor = visitor(0, 0, 0.5, false, new Vector2(1, 0), new Vector2(1, 1));
        World world = world(new Pose(5, 3.5, 0), visitor);
        assertAt(1, 0.5, positionAfter(world, 3));
        Obstacle faster = visitor(1, 0.5, 1, false, new Vector2(1, 0), new Vector2(1, 1));
        assertEquals(
                Optional.empty(),
                world.execute(new Command.PlaceObstacle(faster)).refusal());
        assertAt(1, 0.75, positionAfter(world, 0.25));
    }

    @Test
    void onAnotherPathItGoesToTheFirstWaypoint() {
        World world = world(new Pose(5, 3.5, 0), visitor(0, 0, 0.5, false, new Vector2(1, 0), new Vector2(1, 1)));
        positionAfter(world, 3);
        assertEquals(
                Optional.empty(),
                world.execute(new Command.PlaceObstacle(
                                visitor(1, 0.5, 0.5, false, new Vector2(0, 0.5), new Vector2(1, 1))))
                        .refusal());
        assertAt(0.5, 0.5, positionAfter(world, 1));
    }

    @Test
    void withoutALoopItStaysAtTheLastWaypoint() {
        World world = world(new Pose(5, 3.5, 0), visitor(0, 0, 0.5, false, new Vector2(1, 0)));
        assertAt(1, 0, positionAfter(world, 10));
    }

    @Test
    void withALoopTheLastWaypointIsFollowedByTheFirst() {
        World world = world(new Pose(5, 3.5, 0), visitor(0, 0, 0.5, true, new Vector2(0, 0), new Vector2(1, 0)));
        assertAt(0.5, 0, positionAfter(world, 3));
        assertAt(0.5, 0, positionAfter(world, 2));
    }

    @Test
    void manyWaypointsMayFallIntoOneTick() {
        World world = world(
                new Pose(5, 3.5, 0),
                visitor(
                        0,
                        0,
                        100,
                        true,
                        new Vector2(0, 0),
                        new Vector2(0.1, 0),
                        new Vector2(0.1, 0.1),
                        new Vector2(0, 0.1)));
        // 1 m a tick is two and a half times round the square of 0.4 m.
        assertAt(0.1, 0.1, positionAfter(world, TICK));
    }

    @Test
    void coincidentWaypointsAreAStandstill() {
        World world = world(new Pose(5, 3.5, 0), visitor(1, 1, 1, true, new Vector2(1, 1), new Vector2(1, 1)));
        assertAt(1, 1, positionAfter(world, 1));
    }

    @Test
    void itStopsAtTheStandingRobotAndThatIsTheRobotsCollision() {
        // The robot's left flank is at y = 2.1; the visitor comes down from above and touches it with its centre at
        // 2.2.
        World world = world(new Pose(2, 2, 0), visitor(2, 3, 0.5, false, new Vector2(2, 0)));
        assertAt(2, 2.2, positionAfter(world, 5));
        Collision collision = world.collision().orElseThrow();
        assertEquals("visitor", collision.obstacle());
        assertAt(2, 2.1, collision.point());
        assertEquals(1.6, collision.time(), 1e-9);
    }

    @Test
    void itResumesWhenItsPathLeadsAway() {
        World world = world(new Pose(2, 2, 0), visitor(2, 3, 0.5, true, new Vector2(2, 2.2), new Vector2(2, 3)));
        // It turns round where it just touches: 1.6 s to get there, 1.6 s to come back.
        assertAt(2, 3, positionAfter(world, 3.2));
    }

    @Test
    void oneThatTheRobotRunsIntoIsStoppedWithIt() {
        World world = world(new Pose(2, 2, 0), visitor(3, 2, 0.01, false, new Vector2(3, 3)));
        for (int i = 0; i < 500; i++) {
            world.move(6, 6);
        }
        assertEquals("visitor", world.collision().orElseThrow().obstacle());
        assertTrue(world.pose().x() < 2.8);
    }

    /** The inverse is the command that a file can contain, which places an obstacle like a new one. */
    @Test
    void anObstacleWhoseRemovalIsUndoneIsAboveTheOthersAndMovesToItsFirstWaypoint() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(3, 3, 0));
        World world = world(new Pose(5, 3.5, 0), visitor(0, 0, 0.5, false, new Vector2(1, 0), new Vector2(1, 1)), pole);
        assertAt(1, 0.5, positionAfter(world, 3));
        world.execute(new Command.RemoveObstacle("visitor")).inverse().forEach(world::execute);
        List<Obstacle> obstacles = world.snapshot().obstacles();
        assertEquals(
                List.of("pole", "visitor"), obstacles.stream().map(Obstacle::id).toList());
        assertAt(1, 0.5, obstacles.get(1).pose().position());
        positionAfter(world, 0.5);
        assertAt(1, 0.25, world.snapshot().obstacles().get(1).pose().position());
        positionAfter(world, 1);
        assertAt(1, 0.25, world.snapshot().obstacles().get(1).pose().position());
    }

    @Test
    void movingObstaclesKeepTheirOrderWhateverReplacesThem() {
        ObstacleSet obstacles = new ObstacleSet(new WorldSpec(6, 4, false, 3, List.of()));
        List<String> ids = List.of("a", "b", "c", "d", "e");
        ids.forEach(id -> obstacles.put(named(id, true)));
        for (String id : ids) {
            MovingObstacle before = (MovingObstacle) obstacles.find(id).orElseThrow();
            obstacles.put(named(id, true));
            assertEquals(ids, movingIds(obstacles));
            assertTrue(before.isRemoved());
            obstacles.put(named(id, false));
            assertEquals(ids.stream().filter(other -> !other.equals(id)).toList(), movingIds(obstacles));
            assertEquals(4, obstacles.countMovingExcept(id));
            obstacles.put(named(id, true));
            assertEquals(ids, movingIds(obstacles));
            assertEquals(4, obstacles.countMovingExcept(id));
        }
        assertEquals(5, obstacles.countMovingExcept("f"));
        obstacles.remove(obstacles.find("b").orElseThrow());
        assertEquals(List.of("a", "c", "d", "e"), movingIds(obstacles));
    }

    private static Obstacle named(String id, boolean moving) {
        WaypointPath motion = moving ? new WaypointPath(1, false, List.of(new Vector2(1, 0))) : WaypointPath.NONE;
        return new Obstacle(id, new ObstacleShape.CircleShape(0.1), new Pose(0, 0, 0), motion);
    }

    private static List<String> movingIds(ObstacleSet obstacles) {
        return obstacles.moving().stream().map(MovingObstacle::id).toList();
    }

    @Test
    void puttingManyMovingObstaclesNeedsTimeInProportionToTheirNumber() {
        int count = 40_000;
        World world =
                new World(new WorldSpec(6, 4, false, count, List.of()), RobotSpec.DEFAULT, new Pose(3, 3, 0), TICK, 1);
        CpuTime time = CpuTime.start();
        for (int i = 0; i < 2 * count; i++) {
            CommandResult result = world.execute(new Command.PlaceObstacle(named("a" + i % count, true)));
            assertEquals(Optional.empty(), result.refusal());
        }
        assertEquals(
                Refusal.Reason.TOO_MANY_MOVING,
                world.execute(new Command.PlaceObstacle(named("b", true)))
                        .refusal()
                        .orElseThrow()
                        .reason());
        time.assertBelow(3);
    }
}
