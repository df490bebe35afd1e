package faultline.control.fallback;

import faultline.control.diagnosis.DeadReckoning;
import faultline.geometry.Angles;
import java.util.function.DoubleBinaryOperator;

/**
 * Finds the direction along the wall: the first one, clockwise from the direction of the wall, that keeps the wanted
 * distance from surfaces.
 */
final class FreeDirectionFinder {

    /** The angle between two directions that are tried, radians. */
    private static final double STEP = StrictMath.toRadians(5);

    /** The number of directions that are tried: together less than a turn. */
    private static final int DIRECTIONS = 66;

    /** The distance between two places that are tested along a strip, metres. */
    private static final double SPACING = 0.03;

    /** The distance of the first of these places from the platform's front, metres. */
    private static final double MARGIN = 0.025;

    /**
     * In the middle of the path, surfaces may be nearer than wanted, or than they are at its start, by this, metres.
     */
    private static final double NEARER = 0.02;

    /** The largest angle to the last direction of one that continues it, radians. */
    private static final double CONTINUES_WITHIN = StrictMath.toRadians(40);

    /**
     * Such a direction may be nearer to surfaces on the right by this, metres. The measured width of a passage changes
     * from plan to plan, and the robot would turn to and fro before one that is hardly wide enough.
     */
    private static final double CONTINUES_NEARER = 0.04;

    private final LocalMap map;
    private double direction;
    private double unknownX;
    private double unknownY;

    FreeDirectionFinder(LocalMap map) {
        this.map = map;
    }

    /**
     * Sets the direction that counts as the last one, until another is found.
     *
     * @param newDirection radians
     */
    void begin(double newDirection) {
        direction = newDirection;
    }

    /**
     * Finds the first direction that is free. One that continues the last one is free at a slightly smaller distance
     * from surfaces on the right of the path, if a smaller one is to be kept from these than from others.
     *
     * @param at the position of the robot
     * @param from the direction of the wall, radians
     * @param length the length that must be free, metres
     * @param clearance to be kept from surfaces
     * @return whether a direction is free; if none is, the last one that was found remains
     */
    boolean find(DeadReckoning at, double from, double length, PathClearance clearance) {
        for (int i = 0; i < DIRECTIONS; i++) {
            double candidate = from - i * STEP;
            if (isFree(at, candidate, length, clearance)) {
                direction = candidate;
                return true;
            }
        }
        return false;
    }

    private boolean isFree(DeadReckoning at, double candidate, double length, PathClearance clearance) {
        double cos = StrictMath.cos(candidate);
        double sin = StrictMath.sin(candidate);
        double dx = length * cos;
        double dy = length * sin;
        if (clearance.isSameAround()) {
            return isOpen(at, dx, dy, clearance.onRight(), map::toSurface);
        }
        double onRight = continues(candidate) ? clearance.onRight() - CONTINUES_NEARER : clearance.onRight();
        DoubleBinaryOperator toSurfaceOnLeft = (x, y) -> map.toSurfaceOnLeft(x, y, cos, sin, clearance.halfWidth());
        return isOpen(at, dx, dy, onRight, map::toSurface) && isOpen(at, dx, dy, clearance.onLeft(), toSurfaceOnLeft);
    }

    private boolean continues(double candidate) {
        return Math.abs(Angles.difference(candidate, direction)) < CONTINUES_WITHIN;
    }

    /** Returns the direction that was found last, radians. */
    double direction() {
        return direction;
    }

    /** Returns whether the end and the middle of a path, given by its vector, are far enough from surfaces. */
    private static boolean isOpen(
            DeadReckoning at, double dx, double dy, double distance, DoubleBinaryOperator toSurface) {
        double end = toSurface.applyAsDouble(at.x() + dx, at.y() + dy);
        if (end < distance) {
            return false;
        }
        double middle = toSurface.applyAsDouble(at.x() + dx / 2, at.y() + dy / 2);
        return middle >= Math.min(distance, toSurface.applyAsDouble(at.x(), at.y())) - NEARER;
    }

    /**
     * Returns how far the robot can roll in a direction over ground that is known to be free: a strip as wide as the
     * robot, ahead of its front.
     *
     * @param at the position of the robot
     * @param towards the direction, radians
     * @param limit metres
     * @param front from the centre to the platform's front, metres
     * @param half half the platform's width, metres
     * @return metres; less than 0 if the first place is not known to be free
     */
    double known(DeadReckoning at, double towards, double limit, double front, double half) {
        double cos = StrictMath.cos(towards);
        double sin = StrictMath.sin(towards);
        for (double way = 0; way < limit; way += SPACING) {
            double ahead = front + MARGIN + way;
            for (int side = -1; side <= 1; side++) {
                double px = at.x() + ahead * cos - side * half * sin;
                double py = at.y() + ahead * sin + side * half * cos;
                if (!map.isKnown(px, py)) {
                    unknownX = px;
                    unknownY = py;
                    return way - SPACING;
                }
            }
        }
        return limit;
    }

    /**
     * Returns the x coordinate of the place that ended the last strip that was not known to be free up to the limit,
     * metres.
     */
    double unknownX() {
        return unknownX;
    }

    /** Returns the y coordinate of that place, metres. */
    double unknownY() {
        return unknownY;
    }
}
