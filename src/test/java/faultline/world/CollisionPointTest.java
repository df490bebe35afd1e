package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where a robot touches what it drives into. The platform is 0.25 m long and 0.20 m wide and drives along y = 1. */
class CollisionPointTest {

    private static final double TOLERANCE = 1e-6;
    private static final double VOLTS = 4;

    private static Collision collisionWith(ObstacleShape shape, Pose pose) {
        return collisionIn(new WorldSpec(3, 2, true, 100, List.of(new Obstacle("thing", shape, pose))));
    }

    private static Collision collisionIn(WorldSpec spec) {
        World world = new World(spec, RobotSpec.DEFAULT, new Pose(1, 1, 0), 0.01, 1);
        for (int tick = 0; tick < 1000 && world.collision().isEmpty(); tick++) {
            world.move(VOLTS, VOLTS);
        }
        return world.collision().orElseThrow();
    }

    private static void assertTouches(String obstacle, double x, double y, Collision collision) {
        assertEquals(obstacle, collision.obstacle());
        assertEquals(0, collision.point().distanceTo(new Vector2(x, y)), TOLERANCE, () -> "at " + collision.point());
    }

    private static ObstacleShape wall(double x1, double y1, double x2, double y2) {
        return new ObstacleShape.WallShape(List.of(new Vector2(x1, y1), new Vector2(x2, y2)));
    }

    @Test
    void aFrontThatMeetsALongWallTouchesItInTheMiddle() {
        assertTouches(WorldSpec.ENCLOSURE, 3, 1, collisionIn(new WorldSpec(3, 2, true, 100, List.of())));
        assertTouches("thing", 1.8, 1, collisionWith(wall(1.8, 0.3, 1.8, 1.9), Pose.ORIGIN));
    }

    @Test
    void aFrontThatMeetsAShortWallTouchesTheMiddleOfTheWall() {
        assertTouches("thing", 1.8, 0.985, collisionWith(wall(1.8, 0.95, 1.8, 1.02), Pose.ORIGIN));
    }

    @Test
    void aFrontThatMeetsAWallThatSticksOutOnOneSideTouchesItWhereTheyOverlap() {
        assertTouches("thing", 1.8, 1.04, collisionWith(wall(1.8, 0.98, 1.8, 1.5), Pose.ORIGIN));
    }

    /** The mover is the first in the list, and slides along the line of the two walls. */
    @Test
    void ofSeveralObstaclesThatAreTouchedAtOnceTheFirstThatStandsIsNamed() {
        WaypointPath down = new WaypointPath(0.01, false, List.of(new Vector2(1.9, 0.2)));
        Obstacle mover = new Obstacle(
                "mover", new ObstacleShape.RectangleShape(0.2, 0.4), new Pose(1.9, 0.75, 0), down, Obstacle.MATT);
        Obstacle upper = new Obstacle("upper", wall(1.8, 1.05, 1.8, 1.5), Pose.ORIGIN);
        Obstacle middle = new Obstacle("middle", wall(1.8, 0.98, 1.8, 1.02), Pose.ORIGIN);
        assertEquals(
                "upper",
                collisionIn(new WorldSpec(3, 2, true, 100, List.of(mover, upper, middle)))
                        .obstacle());
        assertEquals(
                "middle",
                collisionIn(new WorldSpec(3, 2, true, 100, List.of(mover, middle, upper)))
                        .obstacle());
    }

    @Test
    void aFrontTouchesTheEndOfAWall() {
        assertTouches("thing", 1.8, 1.03, collisionWith(wall(1.8, 1.03, 2.2, 1.1), Pose.ORIGIN));
        assertTouches("thing", 1.8, 0.97, collisionWith(wall(2.2, 0.9, 1.8, 0.97), Pose.ORIGIN));
    }

    @Test
    void aCornerOfThePlatformTouchesASlantedWall() {
        assertTouches("thing", 1.5, 1.1, collisionWith(wall(0.9, 1.7, 1.9, 0.7), new Pose(0, 0, 0)));
        assertTouches("thing", 1.5, 0.9, collisionWith(wall(0.9, 0.3, 1.9, 1.3), new Pose(0, 0, 0)));
    }

    /** The mean of the places would be in the middle of the platform. */
    @Test
    void aPlatformThatTurnsBetweenTwoSidesOfAWallTouchesOneOfThem() {
        ObstacleShape corridor = new ObstacleShape.WallShape(
                List.of(new Vector2(0, 0.85), new Vector2(3, 0.85), new Vector2(3, 1.15), new Vector2(0, 1.15)));
        WorldSpec spec = new WorldSpec(4, 2, true, 100, List.of(new Obstacle("thing", corridor, Pose.ORIGIN)));
        World world = new World(spec, RobotSpec.DEFAULT, new Pose(1, 1, 0), 0.01, 1);
        while (world.collision().isEmpty()) {
            world.move(VOLTS / 4, -VOLTS / 4);
        }
        Collision collision = world.collision().orElseThrow();
        assertEquals(0.15, Math.abs(collision.point().y() - 1), TOLERANCE);
        assertEquals(2, world.snapshot().contacts().size());
        assertTrue(world.snapshot().contacts().contains(collision.point()));
    }

    @Test
    void aFrontTouchesACircleAtItsNearestPoint() {
        assertTouches("thing", 1.5, 1.05, collisionWith(new ObstacleShape.CircleShape(0.2), new Pose(1.7, 1.05, 2)));
    }

    @Test
    void aSideThatMeetsTheCornerOfARectangleTouchesTheCorner() {
        ObstacleShape square = new ObstacleShape.RectangleShape(0.2, 0.2);
        double half = Math.sqrt(0.02);
        assertTouches("thing", 1.8 - half, 1.02, collisionWith(square, new Pose(1.8, 1.02, Math.PI / 4)));
    }
}
