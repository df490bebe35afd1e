package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The obstacles of snapshots of a world in which a few of very many move. */
class PlacedListTest {

    private static final double TICK = 0.01;

    private static Obstacle box(String id, double x, double y) {
        return new Obstacle(id, new ObstacleShape.RectangleShape(0.2, 0.1), new Pose(x, y, 0));
    }

    private static Obstacle mover(String id, double y) {
        WaypointPath motion = new WaypointPath(1, true, List.of(new Vector2(1, y), new Vector2(9, y)));
        return new Obstacle(id, new ObstacleShape.CircleShape(0.1), new Pose(1, y, 0), motion);
    }

    private static World world(List<Obstacle> obstacles) {
        return new World(new WorldSpec(500, 500, true, 3, obstacles), RobotSpec.DEFAULT, new Pose(5, 250, 0), TICK, 1);
    }

    private static List<String> idsAndPlaces(World world) {
        return world.snapshot().obstacles().stream()
                .map(obstacle ->
                        obstacle.id() + " " + Math.round(100 * obstacle.pose().x()))
                .toList();
    }

    @Test
    void theMoversAreInTheirPlacesOfTheDrawingOrderAfterEachEdit() {
        World world = world(List.of(mover("a", 1), box("b", 2, 2), box("c", 3, 2), mover("d", 3), box("e", 4, 2)));
        assertEquals(List.of("a 100", "b 200", "c 300", "d 100", "e 400"), idsAndPlaces(world));
        world.move(0, 0);
        assertEquals(List.of("a 101", "b 200", "c 300", "d 101", "e 400"), idsAndPlaces(world));
        world.execute(new Command.RemoveObstacle("a"));
        world.execute(new Command.PlaceObstacle(mover("f", 5)));
        assertEquals(List.of("b 200", "c 300", "d 101", "e 400", "f 100"), idsAndPlaces(world));
        world.execute(new Command.PlaceObstacle(mover("b", 6)));
        world.execute(new Command.PlaceObstacle(box("d", 7, 2)));
        world.move(0, 0);
        assertEquals(List.of("b 101", "c 300", "d 700", "e 400", "f 101"), idsAndPlaces(world));
        world.execute(new Command.MoveObstacle("c", new Pose(8, 2, 0)));
        world.execute(new Command.RemoveObstacle("b"));
        world.execute(new Command.RemoveObstacle("f"));
        assertEquals(List.of("c 800", "d 700", "e 400"), idsAndPlaces(world));
    }

    @Test
    void itEqualsAListOfTheSameObstaclesAndCannotChange() {
        World world = world(List.of(box("b", 2, 2), mover("a", 1)));
        world.move(0, 0);
        List<Obstacle> before = world.snapshot().obstacles();
        List<Obstacle> copy = new ArrayList<>(before);
        assertEquals(copy, before);
        assertEquals(copy.hashCode(), before.hashCode());
        world.move(0, 0);
        world.execute(new Command.RemoveObstacle("b"));
        assertEquals(copy, before, "later ticks and edits do not change it");
        assertThrows(UnsupportedOperationException.class, () -> before.set(0, copy.get(1)));
        assertThrows(UnsupportedOperationException.class, before::clear);
    }

    /** As each keyframe of a run does. */
    @Test
    void snapshotsShareTheStillObstacles() {
        List<Obstacle> obstacles = new ArrayList<>(List.of(mover("mover", 1)));
        for (int i = 0; i < 40_000; i++) {
            obstacles.add(box("box" + i, 20 + i % 200 * 2, 20 + i / 200 * 2));
        }
        World world = world(obstacles);
        world.sense();
        world.snapshot();
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        List<Obstacle> first = world.snapshot().obstacles();
        long allocated = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(allocated < 50_000, allocated + " bytes");
        world.move(0, 0);
        List<Obstacle> second = world.snapshot().obstacles();
        assertNotSame(first.get(0), second.get(0));
        assertSame(first.get(40_000), second.get(40_000));
    }
}
