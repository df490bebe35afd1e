package faultline.geometry;

import java.awt.geom.AffineTransform;

/** Rigid motion in the plane as affine transforms: the paper's eq. (1), from our own sine and cosine. */
public final class RigidMotion {

    private RigidMotion() {}

    /**
     * The rotation about a point, T(x_b, y_b) R(theta) T(-x_b, -y_b), eq. (1) of the paper.
     *
     * @param centre (x_b, y_b), metres
     * @param theta radians, counter-clockwise
     * @return a new transform that leaves {@code centre} where it is
     */
    public static AffineTransform rotationAbout(Vector2 centre, double theta) {
        double cos = StrictMath.cos(theta);
        double sin = StrictMath.sin(theta);
        double xb = centre.x();
        double yb = centre.y();
        // eq. (1): the last column is [x_b (1 - cos) + y_b sin, y_b (1 - cos) - x_b sin]
        return new AffineTransform(cos, sin, -sin, cos, xb * (1 - cos) + yb * sin, yb * (1 - cos) - xb * sin);
    }

    /**
     * The motion that carries the origin, heading 0, to a pose.
     *
     * @param pose the pose
     * @return a new transform from the pose's frame to the outer frame
     */
    public static AffineTransform poseTransform(Pose pose) {
        double cos = StrictMath.cos(pose.heading());
        double sin = StrictMath.sin(pose.heading());
        return new AffineTransform(cos, sin, -sin, cos, pose.x(), pose.y());
    }

    /**
     * A point carried by a transform.
     *
     * @param motion the transform
     * @param point the point
     * @return the image of the point
     */
    public static Vector2 apply(AffineTransform motion, Vector2 point) {
        double x = motion.getScaleX() * point.x() + motion.getShearX() * point.y() + motion.getTranslateX();
        double y = motion.getShearY() * point.x() + motion.getScaleY() * point.y() + motion.getTranslateY();
        return new Vector2(x, y);
    }
}
