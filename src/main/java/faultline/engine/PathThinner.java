package faultline.engine;

import java.util.ArrayList;
import java.util.List;

/**
 * Selects points of a path so that the lines between them stay within a tolerance of all omitted points. From each
 * selected point, it intersects the sectors of directions in which a line passes all following points closely enough,
 * until a point lies outside the intersection or the path turns back.
 */
final class PathThinner {

    private final RobotPath path;
    private final double tolerance;
    private final List<Integer> selected = new ArrayList<>();
    private int anchor;
    private double farthest;
    private boolean open;
    private double leftX;
    private double leftY;
    private double rightX;
    private double rightY;

    private PathThinner(RobotPath path, double tolerance) {
        this.path = path;
        this.tolerance = tolerance;
    }

    /**
     * Returns the indexes of the selected points in order, the given first and the last one of the path included. No
     * point is farther from the remaining lines than the tolerance, metres. Lines with different tags stay apart.
     */
    static List<Integer> select(RobotPath path, int from, double tolerance) {
        PathThinner thinner = new PathThinner(path, tolerance);
        thinner.restart(from);
        for (int i = from + 1; i < path.size(); i++) {
            if (!thinner.extend(i)) {
                thinner.restart(i - 1);
                thinner.extend(i);
            }
        }
        if (path.size() - 1 > thinner.anchor) {
            thinner.selected.add(path.size() - 1);
        }
        return thinner.selected;
    }

    private void restart(int index) {
        selected.add(index);
        anchor = index;
        farthest = 0;
        open = false;
    }

    /** Adds a point to the current line and returns whether it still passes all points closely enough. */
    private boolean extend(int index) {
        double dx = path.x(index) - path.x(anchor);
        double dy = path.y(index) - path.y(anchor);
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (index > anchor + 1 && path.tag(index) != path.tag(index - 1)) {
            return false;
        }
        if (!open && distance <= tolerance) {
            return true;
        }
        if (distance < farthest || open && !contains(dx, dy)) {
            return false;
        }
        farthest = distance;
        narrow(dx / distance, dy / distance, Math.min(1, tolerance / distance));
        return true;
    }

    private boolean contains(double dx, double dy) {
        return rightX * dy - rightY * dx >= 0
                && dx * leftY - dy * leftX >= 0
                && dx * (leftX + rightX) + dy * (leftY + rightY) > 0;
    }

    /** Intersects the directions with those at most an angle from a unit vector; the angle is given by its sine. */
    private void narrow(double ux, double uy, double sine) {
        double cosine = Math.sqrt(1 - sine * sine);
        double newLeftX = ux * cosine - uy * sine;
        double newLeftY = uy * cosine + ux * sine;
        double newRightX = ux * cosine + uy * sine;
        double newRightY = uy * cosine - ux * sine;
        if (!open || newLeftX * leftY - newLeftY * leftX > 0) {
            leftX = newLeftX;
            leftY = newLeftY;
        }
        if (!open || rightX * newRightY - rightY * newRightX > 0) {
            rightX = newRightX;
            rightY = newRightY;
        }
        open = true;
    }
}
