package faultline.world;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The world as a scenario describes it, before anything moves. The origin is its lower left corner.
 *
 * @param width along x, metres, positive
 * @param height along y, metres, positive
 * @param enclosed whether a wall without thickness runs round it, from (0, 0) to (width, height)
 * @param maxMoving how many obstacles may have a motion, not negative
 * @param obstacles in drawing order; ids are unique
 */
public record WorldSpec(double width, double height, boolean enclosed, int maxMoving, List<Obstacle> obstacles) {

    /** How many obstacles may move where a file does not say, as in the paper. */
    public static final int DEFAULT_MAX_MOVING = 3;

    /** The id that contacts with the enclosing wall are reported under; no obstacle may have it. */
    public static final String ENCLOSURE = "enclosure";

    public WorldSpec {
        if (!(width > 0 && height > 0 && Double.isFinite(width) && Double.isFinite(height))) {
            throw new IllegalArgumentException("a world's width and height must be positive: " + width + ", " + height);
        }
        obstacles = List.copyOf(obstacles);
        Set<String> ids = new HashSet<>();
        ids.add(ENCLOSURE);
        for (Obstacle obstacle : obstacles) {
            if (!ids.add(obstacle.id())) {
                throw new IllegalArgumentException("two obstacles are called " + obstacle.id());
            }
        }
        long moving = obstacles.stream()
                .filter(obstacle -> obstacle.motion().isPresent())
                .count();
        if (moving > maxMoving) {
            throw new IllegalArgumentException(moving + " obstacles move, at most " + maxMoving + " may");
        }
    }
}
