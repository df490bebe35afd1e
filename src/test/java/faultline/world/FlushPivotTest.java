package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.Velocity;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A body that lies almost flush against a long wall and turns touches it with a corner and does not enter it. */
class FlushPivotTest {

    private static final double LENGTH = 0.25;
    private static final double WIDTH = 0.20;
    private static final double TICK = 0.01;
    private static final double TOLERANCE = 1e-9;

    @Test
    void theCornerThatTurnsToTheWallTouchesIt() {
        SplittableRandom random = new SplittableRandom(1479);
        int contacts = 0;
        for (int i = 0; i < 4000; i++) {
            double wallLength = random.nextDouble(4, 1000);
            Segment wall = new Segment(0, wallLength, 0, 0);
            double x = LENGTH / 2 + random.nextDouble(1.5e-9, 1e-7);
            Pose start = new Pose(x, random.nextDouble(1, wallLength - 1), StrictMath.PI);
            Velocity velocity = new Velocity(random.nextDouble(-0.3, 0.3), random.nextDouble(-2, 2));
            double time = new TimeOfImpact(LENGTH, WIDTH, velocity).firstContactTime(start, wall, Vector2.ZERO, TICK);
            if (time < Double.POSITIVE_INFINITY) {
                contacts++;
                double gap = leastX(DifferentialDrive.advance(start, velocity, time));
                assertEquals(0, gap, TOLERANCE, () -> velocity + " from " + start + " beside " + wall);
            }
        }
        assertTrue(contacts > 1000, contacts + " contacts");
    }

    /** Returns the least x of the corners of the body at a pose: its distance from the wall, negative beyond it. */
    private static double leastX(Pose pose) {
        OrientedBox box = new OrientedBox(pose, LENGTH, WIDTH);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < OrientedBox.CORNERS; i++) {
            least = Math.min(least, box.corner(i).x());
        }
        return least;
    }
}
