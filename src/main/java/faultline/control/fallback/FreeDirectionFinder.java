package faultline.control.fallback;

import faultline.control.diagnosis.DeadReckoning;

/**
 * Finds the direction along the wall: the first one, clockwise from the direction of the wall, that keeps the wanted
 * distance from all surfaces.
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

    private final LocalMap map;
    private double direction;
    private double unknownX;
    private double unknownY;

    FreeDirectionFinder(LocalMap map) {
        this.map = map;
    }

    /**
     * Finds the first direction that is free.
     *
     * @param at the position of the robot
     * @param from the direction of the wall, radians
     * @param length the length that must be free, metres
     * @param distance to be kept from surfaces, metres
     * @return whether a direction is free; if none is, the last one that was found remains
     */
    boolean find(DeadReckoning at, double from, double length, double distance) {
        for (int i = 0; i < DIRECTIONS; i++) {
            double candidate = from - i * STEP;
            if (isOpen(at, candidate, length, distance)) {
                direction = candidate;
                return true;
            }
        }
        return false;
    }

    /** Returns the direction that was found last, radians. */
    double direction() {
        return direction;
    }

    private boolean isOpen(DeadReckoning at, double candidate, double length, double distance) {
        double cos = StrictMath.cos(candidate);
        double sin = StrictMath.sin(candidate);
        double end = map.toSurface(at.x() + length * cos, at.y() + length * sin);
        if (end < distance) {
            return false;
        }
        double middle = map.toSurface(at.x() + length / 2 * cos, at.y() + length / 2 * sin);
        return middle >= Math.min(distance, map.toSurface(at.x(), at.y())) - NEARER;
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
