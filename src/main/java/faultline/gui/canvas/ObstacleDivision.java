package faultline.gui.canvas;

import faultline.world.Obstacle;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The obstacles of a frame, divided into those that are part of the ground and the other ones; {@code apart} are the
 * ids of still obstacles that are not part of the ground.
 */
record ObstacleDivision(List<Obstacle> all, Set<String> apart, List<Obstacle> ground, List<Obstacle> separate) {

    static final ObstacleDivision NONE = new ObstacleDivision(List.of(), Set.of(), List.of(), List.of());

    /** Returns this division if the obstacles are those of the last frame, because there may be many. */
    ObstacleDivision of(List<Obstacle> obstacles, Set<String> newApart) {
        if (obstacles == all && newApart.equals(apart)) {
            return this;
        }
        Map<Boolean, List<Obstacle>> bySeparate = obstacles.stream()
                .collect(
                        Collectors.partitioningBy(obstacle -> obstacle.isMoving() || newApart.contains(obstacle.id())));
        return new ObstacleDivision(obstacles, newApart, bySeparate.get(false), bySeparate.get(true));
    }
}
