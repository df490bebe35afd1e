package faultline.world;

import faultline.geometry.Vec;
import java.util.List;

/**
 * How an obstacle moves: from where it stands to the first way-point, then from each to the next, at constant speed and without turning.
 *
 * @param speed metres per second, not negative
 * @param loop whether the last way-point is followed by the first again, or the obstacle stays there
 * @param points the way-points of the shape's origin, in the world, at least one
 */
public record Motion(double speed, boolean loop, List<Vec> points) {

    public Motion {
        if (!(speed >= 0 && Double.isFinite(speed))) {
            throw new IllegalArgumentException("an obstacle's speed must not be negative: " + speed);
        }
        points = List.copyOf(points);
        if (points.isEmpty() || !points.stream().allMatch(Vec::isFinite)) {
            throw new IllegalArgumentException("a motion needs way-points, all finite: " + points);
        }
    }

    /**
     * The same way at another speed.
     *
     * @param other metres per second, not negative
     * @return the same motion otherwise
     */
    public Motion at(double other) {
        return new Motion(other, loop, points);
    }
}
