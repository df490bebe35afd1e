package faultline.control.fallback;

/**
 * The distances that a path keeps from surfaces. Those on its right may be nearer than those on its left and ahead.
 *
 * @param onLeft to be kept from surfaces on the left, and ahead of the platform, metres
 * @param onRight to be kept from all surfaces, metres
 * @param halfWidth half the platform's width, metres
 */
record PathClearance(double onLeft, double onRight, double halfWidth) {

    /** Returns the clearance with the same distance from all surfaces, metres. */
    static PathClearance around(double distance) {
        return new PathClearance(distance, distance, 0);
    }

    /** Returns whether the distance from all surfaces is enough for those on the left, too. */
    boolean isSameAround() {
        return onRight >= onLeft;
    }
}
