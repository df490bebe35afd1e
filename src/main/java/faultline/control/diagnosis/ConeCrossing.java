package faultline.control.diagnosis;

/**
 * Determines whether the robot's motion can have brought a surface into a sensor's cone and out of it again. A surface
 * that does not move enters and leaves at a border of the cone, at a moment at which this border moves towards it or
 * away from it. If it leaves at the border where it entered, the cone has turned back in between. If it leaves at the
 * other border, the cone has swept its own width.
 */
final class ConeCrossing {

    private static final int LEFT = 1;
    private static final int RIGHT = 2;

    /**
     * If a border moves by less than this share of the sum of its motions by rolling and by turning, the direction of
     * its motion is uncertain.
     */
    private static final double UNSURE = 0.05;

    /** The share of the cone's width that a surface crosses at least, because dead reckoning is not exact. */
    private static final double CROSSED = 0.8;

    private final MotionAccumulator motion;
    private final Ray axis;
    private final Ray leftBorder;
    private final Ray rightBorder;
    /** The width of the cone at a distance of 1. */
    private final double width;

    private double distanceBefore;
    private double headingBefore;
    private int entryBorders;
    private double entryLateralStep;

    /** A direction in the cone: how far its apex is from the robot's centre along it, and its sine. */
    private record Ray(double apex, double sin) {

        static Ray of(MountedCone cone, double offset) {
            double sin = StrictMath.sin(cone.bearing() + offset);
            double cos = StrictMath.cos(cone.bearing() + offset);
            return new Ray(cone.x() * cos + cone.y() * sin, sin);
        }

        /** Returns how far a point at some distance moves to the left. */
        double sideways(double distance, double roll, double turn) {
            return turn * (distance + apex) - roll * sin;
        }
    }

    ConeCrossing(MountedCone cone, MotionAccumulator motion) {
        this.motion = motion;
        this.axis = Ray.of(cone, 0);
        this.leftBorder = Ray.of(cone, cone.half());
        this.rightBorder = Ray.of(cone, -cone.half());
        this.width = 2 * StrictMath.sin(cone.half());
    }

    /** Records that a surface has come into view at some distance. */
    void appear(double distance) {
        entryBorders = borders(distance, 1);
        entryLateralStep = lateralStep(distance);
        distanceBefore = motion.netDistance();
        headingBefore = motion.heading();
    }

    /** Returns whether the surface that came into view last can have left it at some distance. */
    boolean canDisappear(double distance) {
        int exit = borders(distance, -1);
        double swept = Math.abs(
                axis.sideways(distance, motion.netDistance() - distanceBefore, motion.heading() - headingBefore));
        boolean back = (entryBorders & exit) != 0 && swept <= entryLateralStep + lateralStep(distance);
        boolean across = (entryBorders & swapped(exit)) != 0 && swept > CROSSED * distance * width;
        return back || across;
    }

    /** Returns how far a point on the axis has moved sideways in the last step. */
    private double lateralStep(double distance) {
        return Math.abs(axis.sideways(distance, motion.rolled(), motion.turned()));
    }

    private static int swapped(int borders) {
        return (borders & LEFT) << 1 | (borders & RIGHT) >> 1;
    }

    /** Returns the borders that move outwards, for a sign of 1, or inwards, for -1. */
    private int borders(double distance, int sign) {
        boolean left = moves(leftBorder, distance, sign);
        boolean right = moves(rightBorder, distance, -sign);
        return (left ? LEFT : 0) | (right ? RIGHT : 0);
    }

    private boolean moves(Ray border, double distance, int sign) {
        double rolling = border.sideways(distance, motion.rolled(), 0);
        double turning = border.sideways(distance, 0, motion.turned());
        return sign * (rolling + turning) > -UNSURE * (Math.abs(rolling) + Math.abs(turning))
                && (rolling != 0 || turning != 0);
    }
}
