package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.BoxDistance;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A robot that turns by hundreds of radians in a tick collides only with what it touches. */
class FastTurnTest {

    private static final double TICK = 0.1;
    private static final RobotSpec FAST = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 1, 10_000));

    /** The wheel speed that turns the robot on the spot by 846 radians in a tick, in volts. */
    private static final double VOLTS = 846 / TICK * FAST.track() / 2;

    private static World worldWithWallAt(double x) {
        Obstacle wall = new Obstacle(
                "wall", new ObstacleShape.WallShape(List.of(new Vector2(0, -3), new Vector2(0, 3))), new Pose(x, 5, 0));
        return new World(new WorldSpec(10, 10, false, 0, List.of(wall)), FAST, new Pose(5, 5, 0), TICK, 1);
    }

    @Test
    void aPivotInTheOpenNeverCollides() {
        // The corners are 0.16008 m from the centre.
        World world = worldWithWallAt(5.1602);
        for (int i = 0; i < 20; i++) {
            world.move(-VOLTS, VOLTS);
        }
        assertTrue(world.collision().isEmpty());
        assertEquals(20 * 846, world.pose().heading(), 1e-6);
    }

    @Test
    void aPivotBesideAWallTouchesItInItsFirstTurn() {
        World world = worldWithWallAt(5.15);
        world.move(-VOLTS, VOLTS);
        assertEquals("wall", world.collision().orElseThrow().obstacle());
        assertTrue(world.pose().heading() < 1, "the first corner turns to the wall in less than a radian");
    }

    @Test
    void whateverCollidesTouchesWhatItNames() {
        SplittableRandom random = new SplittableRandom(846);
        int collisions = 0;
        for (int i = 0; i < 300; i++) {
            World world = worldWithWallAt(5 + random.nextDouble(0.126, 0.5));
            for (int tick = 0; tick < 5; tick++) {
                world.move(random.nextDouble(-VOLTS, 0), random.nextDouble(0, VOLTS));
            }
            if (world.collision().isPresent()) {
                collisions++;
                OrientedBox body = new OrientedBox(world.pose(), FAST.length(), FAST.width());
                Obstacle wall = world.snapshot().obstacles().get(0);
                double gap = BoxDistance.between(
                                body, ObstacleGeometry.of(wall).parts().get(0))
                        .distance();
                assertEquals("wall", world.collision().orElseThrow().obstacle());
                assertTrue(gap < 1e-6, "gap " + gap);
            }
        }
        assertTrue(collisions > 20, collisions + " collisions");
    }
}
