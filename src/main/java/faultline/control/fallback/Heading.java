package faultline.control.fallback;

import faultline.control.diagnosis.DeadReckoning;

/**
 * The way along the wall: of all directions from the wall's own clockwise, the first that keeps the wanted distance of
 * all surfaces.
 */
final class Heading {

    private static final double STEP = StrictMath.toRadians(5);
    private static final int DIRECTIONS = 66;
    private static final double SPACING = 0.03;

    private final LocalMap map;

    Heading(LocalMap map) {
        this.map = map;
    }

    /**
     * The first direction that is open.
     *
     * @param at where the robot is
     * @param from the direction of the wall, radians
     * @param length that must be open, metres
     * @param distance that is to be kept of surfaces, metres
     * @return radians, not a number where no direction is open
     */
    double along(DeadReckoning at, double from, double length, double distance) {
        for (int i = 0; i < DIRECTIONS; i++) {
            double direction = from - i * STEP;
            if (isOpen(at, direction, length, distance)) {
                return direction;
            }
        }
        return Double.NaN;
    }

    private boolean isOpen(DeadReckoning at, double direction, double length, double distance) {
        double cos = StrictMath.cos(direction);
        double sin = StrictMath.sin(direction);
        double end = map.toSurface(at.x() + length * cos, at.y() + length * sin);
        if (end < distance) {
            return false;
        }
        double middle = map.toSurface(at.x() + length / 2 * cos, at.y() + length / 2 * sin);
        return middle >= Math.min(distance, map.toSurface(at.x(), at.y())) - 0.02;
    }

    /**
     * How far the robot can roll in a direction through places that are known to be free.
     *
     * @param at where the robot is
     * @param direction radians
     * @param limit metres
     * @param radius that must be free about its centre, metres
     * @return metres
     */
    double known(DeadReckoning at, double direction, double limit, double radius) {
        double cos = StrictMath.cos(direction);
        double sin = StrictMath.sin(direction);
        for (double way = SPACING; way < limit; way += SPACING) {
            if (map.toUnknown(at.x() + way * cos, at.y() + way * sin) < radius) {
                return way - SPACING;
            }
        }
        return limit;
    }
}
