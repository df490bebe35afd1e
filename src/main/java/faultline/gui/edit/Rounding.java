package faultline.gui.edit;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.util.List;

/**
 * Rounds the results of drags and key strokes, so that files stay readable: lengths to hundredths of a millimetre,
 * headings to millionths of a degree. What has not changed keeps its bits.
 */
public final class Rounding {

    private static final double STEPS_PER_METRE = 1e5;
    private static final double FINE_STEPS_PER_METRE = 1e9;
    private static final double STEPS_PER_DEGREE = 1e6;
    /** The largest difference, in metres or radians, that is an error of a computation and not a change. */
    private static final double MAX_ERROR = 1e-9;

    private Rounding() {}

    static double round(double value) {
        return round(value, STEPS_PER_METRE);
    }

    private static double round(double value, double steps) {
        return Math.rint(value * steps) / steps;
    }

    /** Returns an angle, radians, rounded to a multiple of a step that is given in degrees. */
    static double roundAngle(double radians, double step) {
        double degrees = Math.rint(Math.toDegrees(radians) / step) * step;
        return Degrees.toRadians(Math.rint(degrees * STEPS_PER_DEGREE) / STEPS_PER_DEGREE);
    }

    /** Returns an angle, radians, rounded to millionths of a degree. */
    public static double roundAngle(double radians) {
        return roundAngle(radians, 1 / STEPS_PER_DEGREE);
    }

    /** Returns the nearest point on a grid of hundredths of a millimetre. */
    public static Vector2 round(Vector2 value) {
        return new Vector2(round(value.x()), round(value.y()));
    }

    static List<Vector2> round(List<Vector2> values) {
        return values.stream().map(Rounding::round).toList();
    }

    /** Returns a point after a move; a coordinate that is as before is not rounded. */
    public static Vector2 round(Vector2 before, Vector2 after) {
        return round(before, after, STEPS_PER_METRE);
    }

    private static Vector2 round(Vector2 before, Vector2 after, double steps) {
        return new Vector2(
                isSame(before.x(), after.x()) ? before.x() : round(after.x(), steps),
                isSame(before.y(), after.y()) ? before.y() : round(after.y(), steps));
    }

    /** Returns a pose after a move; a coordinate or heading that is as before is not rounded. */
    public static Pose round(Pose before, Pose after) {
        Vector2 position = round(before.position(), after.position());
        return new Pose(
                position.x(),
                position.y(),
                isSame(before.heading(), after.heading()) ? before.heading() : roundAngle(after.heading()));
    }

    /** Returns a point after a move as {@link #round(Vector2, Vector2)}, but rounded to nanometres. */
    static Vector2 roundFinely(Vector2 before, Vector2 after) {
        return round(before, after, FINE_STEPS_PER_METRE);
    }

    private static boolean isSame(double before, double after) {
        return Math.abs(after - before) < MAX_ERROR;
    }
}
