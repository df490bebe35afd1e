package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.Disc;
import faultline.geometry.Oval;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;

/**
 * The walls of a world as they stand before anything moves, as ground truth for judging a wall follower: what could be followed at a
 * distance, and how far the nearest wall is. Moving obstacles are no walls. Used by one thread.
 */
public final class WallMap {

    private static final double NONE = Double.POSITIVE_INFINITY;

    private final Candidates figures = new Candidates();
    private final Candidates near = new Candidates();
    private final FigureIndex index;

    /**
     * The walls of a world.
     *
     * @param world before anything moves
     */
    public WallMap(WorldSpec world) {
        new ObstacleField(world).allStatic(figures);
        index = FigureIndex.over(figures);
    }

    /**
     * How much farther than wanted the nearest wall is from a point, if it is a straight piece of wall.
     *
     * @param centre the robot's centre
     * @param wanted the wanted distance from the centre, metres
     * @param margin how far from a segment's ends the foot must lie, metres
     * @return metres, positive for too far; not a number where the nearest wall is not straight, or farther than twice what is wanted
     */
    public double errorOnStraight(Vec centre, double wanted, double margin) {
        near.clear();
        index.near(centre.x(), centre.y(), 2 * wanted, near);
        double least = NONE;
        boolean straight = false;
        for (int i = 0; i < near.size(); i++) {
            Vec nearest = near.figure(i).nearestTo(centre);
            double distance = nearest.distanceTo(centre);
            if (distance < least) {
                least = distance;
                straight = near.figure(i) instanceof Segment segment
                        && nearest.distanceTo(segment.a()) >= margin && nearest.distanceTo(segment.b()) >= margin;
            }
        }
        return straight && least <= 2 * wanted ? least - wanted : Double.NaN;
    }

    /**
     * The places from which walls can be followed: points at a distance from a wall and nowhere nearer to any.
     *
     * @param distance from the wall to the robot's centre, metres
     * @param spacing of the samples along the walls, metres
     * @return samples in the order of the walls
     */
    public List<Place> places(double distance, double spacing) {
        List<Place> places = new ArrayList<>();
        for (int i = 0; i < figures.size(); i++) {
            Convex figure = figures.figure(i);
            if (figure instanceof Segment segment) {
                alongSegment(segment, distance, spacing, places);
            } else if (figure instanceof Disc disc) {
                aroundOval(Oval.at(new Pose(disc.cx(), disc.cy(), 0), disc.radius(), disc.radius()), distance, spacing, places);
            } else {
                aroundOval((Oval) figure, distance, spacing, places);
            }
        }
        return places;
    }

    /**
     * A place from which a piece of wall can be followed.
     *
     * @param at where the robot's centre is then
     * @param length of the piece of wall, metres; 0 for a corner, which only joins two walls
     */
    public record Place(Vec at, double length) {
    }

    private void alongSegment(Segment segment, double distance, double spacing, List<Place> places) {
        double length = segment.length();
        int pieces = Math.max(1, (int) Math.ceil(length / spacing));
        if (length > 0) {
            Vec normal = segment.b().minus(segment.a()).times(1 / length).perpendicular();
            for (int i = 0; i < pieces; i++) {
                Vec foot = segment.at((i + 0.5) / pieces);
                addIfFree(foot, normal, distance, length / pieces, places);
                addIfFree(foot, normal.times(-1), distance, length / pieces, places);
            }
        }
        aroundPoint(segment.a(), distance, spacing, places);
        aroundPoint(segment.b(), distance, spacing, places);
    }

    /** The arc about a corner is free just where the corner juts out. */
    private void aroundPoint(Vec corner, double distance, double spacing, List<Place> places) {
        int pieces = (int) Math.ceil(2 * StrictMath.PI * distance / spacing);
        for (int i = 0; i < pieces; i++) {
            addIfFree(corner, Vec.direction(2 * StrictMath.PI * i / pieces), distance, 0, places);
        }
    }

    private void aroundOval(Oval oval, double distance, double spacing, List<Place> places) {
        int pieces = Math.max(8, (int) Math.ceil(2 * StrictMath.PI * oval.reach() / spacing));
        Vec before = oval.toWorld(new Vec(oval.rx(), 0));
        for (int i = 1; i <= pieces; i++) {
            Vec unit = Vec.direction(2 * StrictMath.PI * i / pieces);
            Vec point = oval.toWorld(new Vec(oval.rx() * unit.x(), oval.ry() * unit.y()));
            Vec across = new Vec(unit.x() / oval.rx(), unit.y() / oval.ry());
            Vec normal = across.times(1 / across.length()).turned(oval.cos(), oval.sin());
            addIfFree(point, normal, distance, point.distanceTo(before), places);
            before = point;
        }
    }

    private void addIfFree(Vec foot, Vec normal, double distance, double length, List<Place> places) {
        Vec place = foot.plus(normal.times(distance));
        near.clear();
        index.near(place.x(), place.y(), distance, near);
        for (int i = 0; i < near.size(); i++) {
            if (near.figure(i).nearestTo(place).distanceTo(place) < distance * (1 - 1e-6)) {
                return;
            }
        }
        places.add(new Place(place, length));
    }
}
