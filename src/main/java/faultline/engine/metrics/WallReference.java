package faultline.engine.metrics;

import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import faultline.world.CandidateBuffer;
import faultline.world.SpatialIndex;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * The walls of a world at the start, as ground truth for wall followers: what can be followed at a distance, and how
 * far the nearest wall is. Moving obstacles do not count as walls. Confined to one thread.
 */
public final class WallReference {

    private static final double NONE = Double.POSITIVE_INFINITY;

    private final CandidateBuffer shapes;
    private final CandidateBuffer candidates = new CandidateBuffer();
    private final SpatialIndex index;

    /** Creates the reference of a world at its start. */
    public WallReference(WorldSpec world) {
        shapes = CandidateBuffer.ofStaticShapes(world);
        index = SpatialIndex.of(shapes);
    }

    /**
     * Returns how much farther than wanted the nearest wall is from a point, metres; NaN if that wall is not straight
     * there, or more than twice as far as wanted.
     *
     * @param centre the robot's centre
     * @param wanted the wanted distance from the centre, metres
     * @param margin the smallest distance of the foot from the ends of a segment, metres
     */
    public double straightWallError(Vector2 centre, double wanted, double margin) {
        WallError error = wallError(centre, wanted, margin);
        return error.straight() ? error.metres() : Double.NaN;
    }

    /**
     * How much farther than wanted the nearest wall is from a point.
     *
     * @param metres positive for too far; NaN if the wall is more than twice as far as wanted
     * @param straight whether the nearest wall is straight there
     */
    record WallError(double metres, boolean straight) {}

    /** Returns how much farther than wanted the nearest wall is; parameters as {@link #straightWallError}. */
    WallError wallError(Vector2 centre, double wanted, double margin) {
        candidates.clear();
        index.findNear(centre.x(), centre.y(), 2 * wanted, candidates);
        double least = NONE;
        boolean straight = false;
        for (int i = 0; i < candidates.size(); i++) {
            Vector2 nearest = candidates.shape(i).nearestTo(centre);
            double distance = nearest.distanceTo(centre);
            if (distance < least) {
                least = distance;
                straight = candidates.shape(i) instanceof Segment segment
                        && nearest.distanceTo(segment.a()) >= margin
                        && nearest.distanceTo(segment.b()) >= margin;
            }
        }
        return new WallError(least <= 2 * wanted ? least - wanted : Double.NaN, straight);
    }

    /** Returns the number of shapes that the walls consist of. */
    int size() {
        return shapes.size();
    }

    /**
     * Returns the places from which walls can be followed, in the order of the walls: points at a distance from a wall
     * and nowhere nearer to any.
     *
     * @param distance from the wall to the robot's centre, metres
     * @param spacing of the samples along the walls, metres
     */
    public List<Sample> samples(double distance, double spacing) {
        return samples(distance, spacing, 0);
    }

    /**
     * Returns the places from which walls can be followed, spaced along the robot's way rather than along the walls, so
     * that those around a pole are as close together as any.
     *
     * @param distance from the wall to the robot's centre, metres
     * @param spacing of the samples along the way, metres
     * @return samples in the order of the walls
     */
    public List<Sample> samplesAlongWay(double distance, double spacing) {
        return samples(distance, spacing, distance);
    }

    private List<Sample> samples(double distance, double spacing, double reach) {
        List<Sample> places = new ArrayList<>();
        for (int i = 0; i < shapes.size(); i++) {
            ConvexShape figure = shapes.shape(i);
            if (figure instanceof Segment segment) {
                sampleAlongSegment(segment, distance, spacing, places);
            } else if (figure instanceof Disc disc) {
                sampleAroundEllipse(disc.toEllipse(), distance, spacing, reach, places);
            } else {
                sampleAroundEllipse((Ellipse) figure, distance, spacing, reach, places);
            }
        }
        return places;
    }

    /**
     * A place from which a piece of wall can be followed.
     *
     * @param position of the robot's centre
     * @param wallLength the length of the piece of wall, metres; 0 for a corner, which only joins two walls
     */
    public record Sample(Vector2 position, double wallLength) {}

    private void sampleAlongSegment(Segment segment, double distance, double spacing, List<Sample> places) {
        double length = segment.length();
        int pieces = Math.max(1, (int) Math.ceil(length / spacing));
        if (length > 0) {
            Vector2 normal = segment.b().minus(segment.a()).times(1 / length).perpendicular();
            for (int i = 0; i < pieces; i++) {
                Vector2 foot = segment.pointAt((i + 0.5) / pieces);
                addIfFree(foot, normal, distance, length / pieces, places);
                addIfFree(foot, normal.times(-1), distance, length / pieces, places);
            }
        }
        sampleAroundPoint(segment.a(), distance, spacing, places);
        sampleAroundPoint(segment.b(), distance, spacing, places);
    }

    /** The arc around a corner is free only where the corner is convex. */
    private void sampleAroundPoint(Vector2 corner, double distance, double spacing, List<Sample> places) {
        int pieces = (int) Math.ceil(2 * StrictMath.PI * distance / spacing);
        for (int i = 0; i < pieces; i++) {
            addIfFree(corner, Vector2.direction(2 * StrictMath.PI * i / pieces), distance, 0, places);
        }
    }

    /** Spaces the samples on the curve that is {@code reach} metres outside the ellipse. */
    private void sampleAroundEllipse(Ellipse oval, double distance, double spacing, double reach, List<Sample> places) {
        int pieces = Math.max(8, (int) Math.ceil(2 * StrictMath.PI * (oval.boundingRadius() + reach) / spacing));
        Vector2 before = oval.frame().toParent(new Vector2(oval.rx(), 0));
        for (int i = 1; i <= pieces; i++) {
            Vector2 unit = Vector2.direction(2 * StrictMath.PI * i / pieces);
            Vector2 point = oval.frame().toParent(new Vector2(oval.rx() * unit.x(), oval.ry() * unit.y()));
            Vector2 across = new Vector2(unit.x() / oval.rx(), unit.y() / oval.ry());
            Vector2 normal = across.times(1 / across.length())
                    .rotated(oval.frame().cos(), oval.frame().sin());
            addIfFree(point, normal, distance, point.distanceTo(before), places);
            before = point;
        }
    }

    private void addIfFree(Vector2 foot, Vector2 normal, double distance, double length, List<Sample> places) {
        Vector2 place = foot.plus(normal.times(distance));
        candidates.clear();
        index.findNear(place.x(), place.y(), distance, candidates);
        for (int i = 0; i < candidates.size(); i++) {
            if (candidates.shape(i).nearestTo(place).distanceTo(place) < distance * (1 - 1e-6)) {
                return;
            }
        }
        places.add(new Sample(place, length));
    }
}
