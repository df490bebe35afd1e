package faultline.world;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The world of a scenario at the start. The origin is its lower left corner.
 *
 * @param width along x, metres, positive
 * @param height along y, metres, positive
 * @param enclosed whether a wall without thickness encloses it, from (0, 0) to (width, height)
 * @param maxMoving the maximum number of moving obstacles, not negative
 * @param obstacles the obstacles, in drawing order; ids are unique
 */
public record WorldSpec(double width, double height, boolean enclosed, int maxMoving, List<Obstacle> obstacles) {

    /** The maximum number of moving obstacles of a scenario that gives none, as in the paper. */
    public static final int DEFAULT_MAX_MOVING = 3;

    /** The id of the enclosing wall in collisions; no obstacle may have it. */
    public static final String ENCLOSURE = "enclosure";

    /**
     * Creates a world.
     *
     * @param width along x, metres, positive
     * @param height along y, metres, positive
     * @param enclosed whether a wall without thickness encloses it, from (0, 0) to (width, height)
     * @param maxMoving the maximum number of moving obstacles, not negative
     * @param obstacles the obstacles, in drawing order; ids are unique
     * @throws IllegalArgumentException if the size is not positive and finite, two obstacles have the same id, one has
     *     the id of the enclosing wall, or too many move
     */
    public WorldSpec {
        if (!(width > 0 && height > 0 && Double.isFinite(width) && Double.isFinite(height))) {
            throw new IllegalArgumentException("a world's width and height must be positive: " + width + ", " + height);
        }
        obstacles = List.copyOf(obstacles);
        Set<String> ids = new HashSet<>(2 * obstacles.size());
        ids.add(ENCLOSURE);
        for (Obstacle obstacle : obstacles) {
            if (!ids.add(obstacle.id())) {
                throw new IllegalArgumentException("two obstacles have the id " + obstacle.id());
            }
        }
        long moving = obstacles.stream().filter(Obstacle::isMoving).count();
        if (moving > maxMoving) {
            throw new IllegalArgumentException(moving + " obstacles move, at most " + maxMoving + " may");
        }
    }

    /**
     * {@return this world with other obstacles}
     *
     * @param newObstacles the new obstacles, with different ids
     */
    public WorldSpec withObstacles(List<Obstacle> newObstacles) {
        return new WorldSpec(width, height, enclosed, maxMoving, newObstacles);
    }
}
