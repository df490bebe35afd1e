package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.BoxDistance;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Obstacles that are moved onto the robot slide along one of its sides first, nearly parallel to it. */
class SlidingObstaclesTest {

    private static final int SLIDES = 2000;
    private static final int SAMPLES = 200;

    /** Above the depth to which an obstacle that is put beside the robot may overlap it, metres. */
    private static final double DEPTH = 1.1e-9;

    @ParameterizedTest
    @CsvSource({"1, 2e-9", "2, 1e-8", "3, 1e-6", "4, 1e-3"})
    void anObstacleThatSlidesAlongTheRobotStopsBeforeItOverlaps(long seed, double gap) {
        SplittableRandom random = new SplittableRandom(seed);
        int collisions = 0;
        for (int i = 0; i < SLIDES; i++) {
            collisions += slide(random, gap) ? 1 : 0;
        }
        assertTrue(collisions > SLIDES / 4, collisions + " collisions");
    }

    /** Slides a block along the robot's left side, by a little towards it, and returns whether they collide. */
    private static boolean slide(SplittableRandom random, double gap) {
        RobotSpec spec = RobotSpec.DEFAULT;
        Pose robot = new Pose(5 + random.nextDouble(), 5 + random.nextDouble(), random.nextDouble(-4, 4));
        double width = random.nextDouble(0.1, 2);
        double height = random.nextDouble(0.1, 2);
        double side = spec.width() / 2 + height / 2 + gap * random.nextDouble(0.5, 1.5);
        double ahead = random.nextDouble(-1, 1) * (spec.length() + width) / 2;
        double slope = gap * random.nextDouble(-1, 3) + Math.pow(10, random.nextDouble(-10, -1));
        double turn = Math.pow(10, random.nextDouble(-16, -8)) * random.nextInt(-1, 2);
        Pose from = atBody(robot, ahead, side, turn);
        Pose to = atBody(robot, ahead + random.nextDouble(-1, 1), side - slope, turn);
        Obstacle block = new Obstacle("block", new ObstacleShape.RectangleShape(width, height), from);
        WorldSpec room = new WorldSpec(10, 10, false, 3, List.of(block));
        if (ObstacleSet.findObstruction(room, room.obstacles(), bodyAt(robot, 0))
                .isPresent()) {
            return false;
        }
        World world = new World(room, spec, robot, 0.01, 1);
        Command move = new Command.MoveObstacle("block", to);
        CommandResult result = world.execute(move);
        assertEquals(Optional.empty(), result.refusal());
        Obstacle moved = world.snapshot().obstacles().get(0);
        boolean collided = world.collision().isPresent();
        // An obstacle that is moved to a free place is put there, even beyond the robot.
        Pose slid = collided ? from : to;
        assertFalse(overlapsOnTheWay(slid, moved, bodyAt(robot, DEPTH)), () -> block + " to " + to + ": " + moved);
        assertEquals(collided, !moved.pose().equals(to));
        assertEquals(move, result.command());
        assertEquals(new Command.MoveObstacle("block", moved.pose()), result.effect());
        return collided;
    }

    private static Pose atBody(Pose robot, double ahead, double left, double turn) {
        Vector2 direction = Vector2.direction(robot.heading());
        Vector2 place = robot.position()
                .plus(direction.times(ahead))
                .plus(direction.perpendicular().times(left));
        return new Pose(place.x(), place.y(), robot.heading() + turn);
    }

    private static OrientedBox bodyAt(Pose pose, double less) {
        return new OrientedBox(pose, RobotSpec.DEFAULT.length() - 2 * less, RobotSpec.DEFAULT.width() - 2 * less);
    }

    private static boolean overlapsOnTheWay(Pose from, Obstacle to, OrientedBox body) {
        Vector2 start = from.position();
        Vector2 way = to.pose().position().minus(start);
        return IntStream.rangeClosed(0, SAMPLES)
                .mapToObj(i -> to.pose().withPosition(start.plus(way.times((double) i / SAMPLES))))
                .anyMatch(pose -> overlaps(ObstacleGeometry.of(to.withPose(pose)), body));
    }

    private static boolean overlaps(ObstacleGeometry geometry, OrientedBox body) {
        return geometry.contains(body.frame().position())
                || geometry.parts().stream()
                        .anyMatch(part -> BoxDistance.between(body, part).distance() == 0);
    }

    @Test
    void theEffectOfAnyOtherCommandIsTheCommand() {
        World world = new World(new WorldSpec(4, 4, true, 1, List.of()), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
        Command off = new Command.SwitchSensor("front", false);
        assertEquals(off, world.execute(off).effect());
        Command refused = new Command.RemoveObstacle("none");
        assertEquals(refused, world.execute(refused).effect());
    }
}
