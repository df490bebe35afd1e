package faultline.engine.walls;

import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import faultline.world.SpatialIndex;
import java.util.Arrays;

/**
 * Finds the nearest wall of points along a path. The walls around a point are kept for the next points, with their
 * distances; while the path is near that point, most of them are certainly farther away than the nearest one.
 */
public final class NearestWall {

    /** The walls are searched again when the path is farther than this from the point of the last search, metres. */
    private static final double MAX_MOVED = 0.1;

    private static final Vector2 NOWHERE = new Vector2(Double.POSITIVE_INFINITY, 0);

    private final SpatialIndex walls;
    private final double range;
    private final CandidateBuffer near = new CandidateBuffer();
    /** The distances of the walls from the point of the last search, metres. */
    private double[] distances = new double[0];

    private Vector2 searched = NOWHERE;
    /** The index of the last nearest wall, which often is the nearest again. */
    private int last;

    /**
     * Creates a search.
     *
     * @param walls the walls
     * @param range the distance beyond which walls are ignored, metres
     */
    public NearestWall(SpatialIndex walls, double range) {
        this.walls = walls;
        this.range = range;
    }

    /**
     * The nearest wall of a point.
     *
     * @param distance metres; positive infinity if there is no wall within the range
     * @param foot its nearest point
     * @param straight whether it is straight there
     */
    public record Wall(double distance, Vector2 foot, boolean straight) {}

    /**
     * {@return the nearest wall of a point; of several, the first in the world}
     *
     * @param point the point
     * @param margin the smallest distance of the foot from the ends of a straight wall, metres
     */
    public Wall of(Vector2 point, double margin) {
        double moved = point.distanceTo(searched);
        if (moved > MAX_MOVED) {
            search(point);
            moved = 0;
        }
        Vector2 foot = last < near.size() ? near.shape(last).nearestTo(point) : NOWHERE;
        double least = foot.distanceTo(point);
        int nearest = last;
        for (int i = 0; i < near.size(); i++) {
            if (distances[i] - moved <= least + WallReference.ROUNDING) {
                Vector2 candidate = near.shape(i).nearestTo(point);
                double distance = candidate.distanceTo(point);
                if (distance < least || distance == least && near.number(i) < near.number(nearest)) {
                    foot = candidate;
                    least = distance;
                    nearest = i;
                }
            }
        }
        last = nearest;
        return least <= range
                ? new Wall(least, foot, isStraight(near.shape(nearest), foot, margin))
                : new Wall(Double.POSITIVE_INFINITY, NOWHERE, false);
    }

    private void search(Vector2 point) {
        double radius = range + MAX_MOVED + WallReference.ROUNDING;
        near.clear();
        walls.findNear(point.x(), point.y(), radius, near);
        near.dropBeyond(point.x(), point.y(), radius);
        distances = near.size() <= distances.length ? distances : Arrays.copyOf(distances, 2 * near.size());
        for (int i = 0; i < near.size(); i++) {
            distances[i] = near.shape(i).distanceTo(point.x(), point.y());
        }
        searched = point;
        last = 0;
    }

    private static boolean isStraight(ConvexShape wall, Vector2 foot, double margin) {
        return wall instanceof Segment segment
                && foot.distanceTo(segment.a()) >= margin
                && foot.distanceTo(segment.b()) >= margin;
    }
}
