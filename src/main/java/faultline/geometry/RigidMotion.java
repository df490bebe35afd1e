package faultline.geometry;

import java.awt.geom.AffineTransform;

/**
 * A rigid motion of the plane, T(x, y) R(theta): a rotation about the origin followed by a translation. It also
 * describes a frame: the motion maps coordinates in the frame to coordinates in the parent frame. Robot, obstacles,
 * sensor mounts and cones are all placed by one, so that an angle's sine and cosine are computed once.
 *
 * @param cos the cosine of theta
 * @param sin the sine of theta
 * @param x the translation, metres
 * @param y the translation, metres
 */
public record RigidMotion(double cos, double sin, double x, double y) {

    private static final double UNIT_TOLERANCE = 1e-9;

    /**
     * Creates a motion.
     *
     * @param cos the cosine of theta
     * @param sin the sine of theta
     * @param x the translation, metres
     * @param y the translation, metres
     * @throws IllegalArgumentException if (cos, sin) is not a unit vector or the translation is not finite
     */
    public RigidMotion {
        requireUnit(cos, sin);
        if (!(Double.isFinite(x) && Double.isFinite(y))) {
            throw new IllegalArgumentException("the translation must be finite: " + x + ", " + y);
        }
    }

    /** Throws an exception unless two numbers are a cosine and a sine of one angle, up to rounding. */
    static void requireUnit(double cos, double sin) {
        if (!(Math.abs(cos * cos + sin * sin - 1) <= UNIT_TOLERANCE)) {
            throw new IllegalArgumentException("no cosine and sine of one angle: " + cos + ", " + sin);
        }
    }

    /**
     * {@return the motion that maps the frame of a pose to its parent frame}
     *
     * @param pose the pose of the frame in its parent frame
     */
    public static RigidMotion of(Pose pose) {
        return new RigidMotion(StrictTrig.cos(pose.heading()), StrictTrig.sin(pose.heading()), pose.x(), pose.y());
    }

    /**
     * {@return {@link #of} a pose as a new transform for {@link java.awt.geom}}
     *
     * @param pose the pose of the frame in its parent frame
     */
    public static AffineTransform poseTransform(Pose pose) {
        RigidMotion motion = of(pose);
        return new AffineTransform(motion.cos, motion.sin, -motion.sin, motion.cos, motion.x, motion.y);
    }

    /**
     * {@return the rotation about a point, T(x_b, y_b) R(theta) T(-x_b, -y_b): eq. (1) of the paper}
     *
     * @param centre (x_b, y_b), metres; it is mapped to itself
     * @param theta radians, counter-clockwise
     */
    public static RigidMotion rotationAbout(Vector2 centre, double theta) {
        double cos = StrictTrig.cos(theta);
        double sin = StrictTrig.sin(theta);
        double xb = centre.x();
        double yb = centre.y();
        // eq. (1): the last column is [x_b (1 - cos) + y_b sin, y_b (1 - cos) - x_b sin]
        return new RigidMotion(cos, sin, xb * (1 - cos) + yb * sin, yb * (1 - cos) - xb * sin);
    }

    /**
     * {@return the image of a point: local coordinates mapped to the parent frame}
     *
     * @param local the point to map, in local coordinates
     */
    public Vector2 toParent(Vector2 local) {
        return new Vector2(x + cos * local.x() - sin * local.y(), y + sin * local.x() + cos * local.y());
    }

    /**
     * {@return the point whose image is the given one: coordinates of the parent frame mapped to local ones}
     *
     * @param parent the image, in coordinates of the parent frame
     */
    public Vector2 toLocal(Vector2 parent) {
        double dx = parent.x() - x;
        double dy = parent.y() - y;
        return new Vector2(cos * dx + sin * dy, cos * dy - sin * dx);
    }

    /**
     * {@return the motion that applies {@code first} and then this one: the frame {@code first} in the parent frame}
     *
     * @param first the motion to apply first
     */
    public RigidMotion after(RigidMotion first) {
        return new RigidMotion(
                cos * first.cos - sin * first.sin,
                sin * first.cos + cos * first.sin,
                x + cos * first.x - sin * first.y,
                y + sin * first.x + cos * first.y);
    }

    /**
     * {@return this motion followed by a translation}
     *
     * @param dx the translation along x, in metres
     * @param dy the translation along y, in metres
     */
    public RigidMotion translated(double dx, double dy) {
        return new RigidMotion(cos, sin, x + dx, y + dy);
    }

    /** {@return the image of the origin} */
    public Vector2 position() {
        return new Vector2(x, y);
    }

    /** {@return the image of the direction (1, 0), a unit vector} */
    public Vector2 axis() {
        return new Vector2(cos, sin);
    }
}
