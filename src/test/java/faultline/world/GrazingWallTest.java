package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.Velocity;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A body that drives along a long wall and comes nearer at a very small angle stops where it touches the wall. */
class GrazingWallTest {

    private static final double LENGTH = 0.25;
    private static final double WIDTH = 0.20;
    private static final double SPEED = 0.3;
    private static final double TOLERANCE = 1e-9;

    @Test
    void theFrontCornerTouchesTheWallInTheTickInWhichItReachesIt() {
        SplittableRandom random = new SplittableRandom(20);
        for (int i = 0; i < 4000; i++) {
            double at = random.nextDouble(1000);
            double tangent = StrictMath.pow(10, -random.nextDouble(1, 6));
            double tick = random.nextDouble(0.01, 1);
            // The left front corner is on the wall after this share of the tick.
            double way = SPEED * tick * random.nextDouble(0.05, 0.95);
            Vector2 contact = new Vector2(at + LENGTH / 2 + way, at + WIDTH / 2);
            Vector2 half = new Vector2(10, -10 * tangent);
            Segment wall = new Segment(contact.minus(half), contact.plus(half));
            double time = new TimeOfImpact(LENGTH, WIDTH, new Velocity(SPEED, 0))
                    .firstContactTime(new Pose(at, at, 0), wall, Vector2.ZERO, tick);
            assertEquals(0, (way - SPEED * time) * tangent, TOLERANCE, "trial " + i);
        }
    }
}
