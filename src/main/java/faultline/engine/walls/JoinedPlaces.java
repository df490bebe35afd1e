package faultline.engine.walls;

import faultline.geometry.Vector2;
import java.util.List;

/** Places joined to connected paths: those that are near to each other belong to one path. */
final class JoinedPlaces {

    /** Returned if there is no place. */
    static final int NONE = -1;

    private final List<WallReference.WallSample> places;
    private final double joinDistance;
    private final PointRuns runs;
    private final DisjointSets paths;
    /** The place that the last search has found. */
    private int found = NONE;

    /** Joins places that are not farther from each other than a distance, metres. */
    JoinedPlaces(List<WallReference.WallSample> places, double joinDistance) {
        this.places = places;
        this.joinDistance = joinDistance;
        runs = new PointRuns(joinDistance);
        paths = new DisjointSets(places.size());
        for (int i = 0; i < places.size(); i++) {
            joinWithEarlier(i);
        }
    }

    private void joinWithEarlier(int i) {
        Vector2 position = places.get(i).position();
        int own = runs.add(position);
        if (runs.isTwin(i, own)) {
            paths.join(i, own);
        } else {
            runs.forEachNear(position, run -> paths.join(i, run));
        }
    }

    /** Returns the path that a place is on, identified by its first place. */
    int path(int place) {
        return paths.least(place);
    }

    /**
     * Returns the path nearest to a point, identified by its first place; {@link #NONE} if there is none within the
     * distance. If a place is within half of it, other paths are not compared.
     */
    int pathNear(Vector2 point) {
        // Neighbouring points are often near the same place.
        if (found == NONE || distance(found, point) > joinDistance / 2) {
            found = NONE;
            runs.forEachNear(point, run -> {
                if (found == NONE || distance(run, point) < distance(found, point)) {
                    found = run;
                }
            });
        }
        return found == NONE ? NONE : path(found);
    }

    private double distance(int place, Vector2 point) {
        return places.get(place).position().distanceTo(point);
    }
}
