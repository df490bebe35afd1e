package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Eq. (1) against the three steps that it is made of, done one after the other on a point. */
class RigidMotionTest {

    @Test
    void equationOneIsTranslateRotateTranslateBack() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            Vector2 centre = new Vector2(random.nextDouble(-10, 10), random.nextDouble(-10, 10));
            Vector2 point = new Vector2(random.nextDouble(-10, 10), random.nextDouble(-10, 10));
            double theta = random.nextDouble(-10, 10);
            Vector2 moved = point.minus(centre);
            Vector2 turned = new Vector2(
                    moved.x() * Math.cos(theta) - moved.y() * Math.sin(theta),
                    moved.x() * Math.sin(theta) + moved.y() * Math.cos(theta));
            assertNear(
                    turned.plus(centre),
                    RigidMotion.rotationAbout(centre, theta).toParent(point),
                    1e-13);
        }
    }

    @Test
    void equationOneIsTheProductOfItsThreeMatrices() {
        Vector2 centre = new Vector2(2, -3);
        AffineTransform product = AffineTransform.getTranslateInstance(2, -3);
        product.concatenate(AffineTransform.getRotateInstance(0.7));
        product.concatenate(AffineTransform.getTranslateInstance(-2, 3));
        double[] expected = new double[6];
        product.getMatrix(expected);
        RigidMotion turn = RigidMotion.rotationAbout(centre, 0.7);
        double[] actual = {turn.cos(), turn.sin(), -turn.sin(), turn.cos(), turn.x(), turn.y()};
        for (int i = 0; i < 6; i++) {
            assertEquals(expected[i], actual[i], 1e-15);
        }
    }

    @Test
    void theCentreStaysWhereItIs() {
        Vector2 centre = new Vector2(5, 7);
        assertNear(centre, RigidMotion.rotationAbout(centre, 1.2).toParent(centre), 1e-14);
    }

    @Test
    void aQuarterTurnIsCounterClockwise() {
        assertNear(
                new Vector2(1, 2),
                RigidMotion.rotationAbout(new Vector2(1, 1), Math.PI / 2).toParent(new Vector2(2, 1)),
                1e-15);
    }

    @Test
    void aPoseTransformMapsPointsAsThePoseDoes() {
        Pose pose = new Pose(1, 2, 0.6);
        Vector2 local = new Vector2(0.3, -0.4);
        Point2D image = RigidMotion.poseTransform(pose).transform(new Point2D.Double(local.x(), local.y()), null);
        assertNear(pose.toParent(local), new Vector2(image.getX(), image.getY()), 1e-15);
        assertNear(local, pose.toLocal(pose.toParent(local)), 1e-15);
    }

    @Test
    void aProductMapsAPointAsItsFactorsDoOneAfterTheOther() {
        RigidMotion first = RigidMotion.of(new Pose(0.3, -1.2, 0.8));
        RigidMotion second = RigidMotion.of(new Pose(-2, 0.7, 2.1));
        Vector2 point = new Vector2(0.6, 1.9);
        assertNear(second.toParent(first.toParent(point)), second.after(first).toParent(point), 1e-14);
        assertNear(second.toParent(first.position()), second.after(first).position(), 1e-14);
        assertEquals(1, second.after(first).axis().length(), 1e-15);
    }

    private static void assertNear(Vector2 expected, Vector2 actual, double tolerance) {
        assertEquals(0, expected.distanceTo(actual), tolerance, () -> expected + " " + actual);
    }
}
