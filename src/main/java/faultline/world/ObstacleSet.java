package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.RandomAccess;
import java.util.stream.IntStream;

/** The obstacles and the enclosing wall of a running world; mutable, confined to the simulation thread. */
final class ObstacleSet {

    /** The initial capacity for the parts of an obstacle: those of a rectangle. */
    private static final int EXPECTED_PARTS = 4;

    private final WorldSpec spec;
    private final Map<String, PlacedObstacle> obstacles;
    private final List<MovingObstacle> moving = new ArrayList<>();
    private final EditableIndex index;
    /** The index of the static shapes at the start. */
    private final SpatialIndex startIndex;

    private long nextOrder;
    private long version;
    /** All obstacles in drawing order, those that move at earlier poses; null after an edit. */
    private List<Obstacle> shared;
    /** The indices of the moving obstacles in that list. */
    private int[] movingPlaces;

    /**
     * The obstacles of a world in drawing order, at one moment. All moments between two edits share the list of the
     * still ones, because there may be very many. Immutable.
     */
    static final class PlacedList extends AbstractList<Obstacle> implements RandomAccess {

        /** All obstacles; those that move are not at their present poses. */
        private final List<Obstacle> shared;
        /** The indices of the obstacles that move, ascending. */
        private final int[] places;

        private final Obstacle[] moving;

        /** Creates a list from arrays that it does not copy. */
        PlacedList(List<Obstacle> shared, int[] places, Obstacle[] moving) {
            this.shared = shared;
            this.places = places;
            this.moving = moving;
        }

        /** Returns a list that cannot change, the same one if it is of this class. */
        static List<Obstacle> copyOf(List<Obstacle> obstacles) {
            return obstacles instanceof PlacedList ? obstacles : List.copyOf(obstacles);
        }

        @Override
        public Obstacle get(int index) {
            int mover = Arrays.binarySearch(places, index);
            return mover >= 0 ? moving[mover] : shared.get(index);
        }

        @Override
        public int size() {
            return shared.size();
        }
    }

    ObstacleSet(WorldSpec spec) {
        this.spec = spec;
        this.obstacles = new LinkedHashMap<>(2 * spec.obstacles().size());
        CandidateBuffer shapes =
                new CandidateBuffer(EXPECTED_PARTS * (1 + spec.obstacles().size()));
        addEnclosure(spec, shapes);
        for (Obstacle obstacle : spec.obstacles()) {
            PlacedObstacle placed = create(obstacle, nextOrder++);
            obstacles.put(obstacle.id(), placed);
            if (placed instanceof MovingObstacle mover) {
                moving.add(mover);
            } else {
                shapes.addAll(placed);
            }
        }
        index = new EditableIndex(shapes);
        startIndex = index.base();
        // No obstacle has changed yet, so the first snapshot needs no list of its own.
        share(spec.obstacles());
    }

    private void share(List<Obstacle> list) {
        shared = list;
        movingPlaces = IntStream.range(0, list.size())
                .filter(place -> list.get(place).isMoving())
                .toArray();
    }

    private static PlacedObstacle create(Obstacle obstacle, long order) {
        return obstacle.isMoving() ? new MovingObstacle(obstacle, order) : new PlacedObstacle(obstacle, order);
    }

    private static void addEnclosure(WorldSpec spec, CandidateBuffer shapes) {
        if (spec.enclosed()) {
            ShapeOwner enclosure = new ShapeOwner(WorldSpec.ENCLOSURE, -1, Obstacle.MATT);
            enclosureSides(spec).forEach(side -> shapes.add(side, enclosure));
        }
    }

    private static List<Segment> enclosureSides(WorldSpec spec) {
        double w = spec.width();
        double h = spec.height();
        return List.of(
                new Segment(0, 0, w, 0), new Segment(w, 0, w, h), new Segment(w, h, 0, h), new Segment(0, h, 0, 0));
    }

    static CandidateBuffer staticShapes(WorldSpec spec) {
        CandidateBuffer shapes = new CandidateBuffer();
        addEnclosure(spec, shapes);
        spec.obstacles().stream()
                .filter(obstacle -> !obstacle.isMoving())
                .forEach(obstacle -> shapes.addAll(new PlacedObstacle(obstacle, 0)));
        return shapes;
    }

    /** Returns the index of the static shapes at the start, the enclosing wall first. */
    SpatialIndex startIndex() {
        return startIndex;
    }

    /** Returns a number that changes whenever static obstacles are edited. */
    long version() {
        return version;
    }

    /** Returns the current obstacles in drawing order; the same list as before if none has changed or moves. */
    List<Obstacle> obstacles() {
        if (shared == null) {
            // An immutable list, which a snapshot does not copy again.
            share(List.copyOf(
                    obstacles.values().stream().map(PlacedObstacle::obstacle).toList()));
        }
        return moving.isEmpty()
                ? shared
                : new PlacedList(
                        shared,
                        movingPlaces,
                        moving.stream().map(MovingObstacle::obstacle).toArray(Obstacle[]::new));
    }

    /** Returns the obstacle with an id. */
    Optional<PlacedObstacle> find(String id) {
        return Optional.ofNullable(obstacles.get(id));
    }

    /** Returns the moving obstacles in drawing order. */
    List<MovingObstacle> moving() {
        return moving;
    }

    /** Returns the number of moving obstacles, without the one with an id if it moves. */
    int countMovingExcept(String id) {
        return moving.size() - (obstacles.get(id) instanceof MovingObstacle ? 1 : 0);
    }

    /** Adds the static shapes near a point, and perhaps others. */
    void findStaticNear(double x, double y, double distance, CandidateBuffer found) {
        index.findNear(x, y, distance, found);
    }

    /** Adds all shapes near a point, and perhaps others: first the static ones, then the moving ones. */
    void findNear(double x, double y, double distance, CandidateBuffer found) {
        index.findNear(x, y, distance, found);
        for (int i = 0; i < moving.size(); i++) {
            if (moving.get(i).isWithin(x, y, distance)) {
                found.addAll(moving.get(i));
            }
        }
    }

    /**
     * Adds an obstacle, or replaces the one with the same id in its place of the drawing order. A moving obstacle that
     * replaces one on the same path continues to the same waypoint.
     */
    void put(Obstacle obstacle) {
        PlacedObstacle old = obstacles.get(obstacle.id());
        PlacedObstacle placed = create(obstacle, old == null ? nextOrder++ : old.order());
        if (old instanceof MovingObstacle before && placed instanceof MovingObstacle after) {
            after.follower().continueFrom(before.follower());
        }
        replace(old, placed);
    }

    /** Moves an obstacle. A moving one continues from there to the same waypoint. */
    void move(PlacedObstacle obstacle, Pose pose) {
        put(obstacle.obstacle().withPose(pose));
    }

    private void replace(PlacedObstacle old, PlacedObstacle placed) {
        obstacles.put(placed.id(), placed);
        shared = null;
        if (old instanceof MovingObstacle before && placed instanceof MovingObstacle after) {
            moving.set(placeOf(before), after);
            before.markRemoved();
            return;
        }
        if (old != null) {
            takeOut(old);
        }
        if (placed instanceof MovingObstacle mover) {
            moving.add(placeOf(mover), mover);
        } else {
            index.add(placed);
            version++;
        }
    }

    void remove(PlacedObstacle obstacle) {
        obstacles.remove(obstacle.id());
        shared = null;
        takeOut(obstacle);
    }

    private void takeOut(PlacedObstacle old) {
        if (old instanceof MovingObstacle mover) {
            moving.remove(placeOf(mover));
            mover.markRemoved();
        } else {
            index.remove(old);
            version++;
        }
    }

    /** Returns the place of an obstacle among the moving ones, or where it must be added, by bisection. */
    private int placeOf(MovingObstacle mover) {
        int from = 0;
        int to = moving.size();
        while (from < to) {
            int middle = (from + to) / 2;
            if (moving.get(middle).order() < mover.order()) {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        return from;
    }

    /** Returns a distance from the centre of a body beyond which it touches nothing, metres. */
    private static double reach(OrientedBox body) {
        return body.boundingRadius() + 2 * Clearance.MIN_DISTANCE;
    }

    /** Returns whether a body neither touches nor overlaps an obstacle. */
    static boolean isClear(OrientedBox body, ObstacleGeometry geometry) {
        Vector2 centre = body.frame().position();
        double reach = reach(body);
        for (ConvexShape part : geometry.parts()) {
            if (part.distanceTo(centre.x(), centre.y()) <= reach
                    && BoxDistance.between(body, part).distance() <= Clearance.MIN_DISTANCE) {
                return false;
            }
        }
        return !geometry.contains(centre);
    }

    /** Returns whether a body overlaps an obstacle by more than a bound of the rounding errors of a contact. */
    static boolean isOverlapping(OrientedBox body, ObstacleGeometry geometry) {
        return !isClear(withoutRounding(body), geometry);
    }

    private static OrientedBox withoutRounding(OrientedBox body) {
        double rounding = 2 * Clearance.MIN_DISTANCE;
        return new OrientedBox(body.frame(), body.halfLength() - rounding, body.halfWidth() - rounding);
    }

    /** Returns the id of the first obstacle that a body touches or overlaps. */
    Optional<String> findObstruction(OrientedBox body) {
        return findObstruction(spec, obstacles(), body);
    }

    /** Returns the id of the first obstacle that a body overlaps by more than a bound of the rounding errors. */
    Optional<String> findOverlapped(OrientedBox body) {
        return findObstruction(spec, obstacles(), withoutRounding(body));
    }

    /** Returns the id of the first obstacle of a world that a body touches or overlaps. */
    static Optional<String> findObstruction(WorldSpec spec, List<Obstacle> obstacles, OrientedBox body) {
        if (spec.enclosed()) {
            for (Segment side : enclosureSides(spec)) {
                if (BoxDistance.between(body, side).distance() <= Clearance.MIN_DISTANCE) {
                    return Optional.of(WorldSpec.ENCLOSURE);
                }
            }
        }
        Vector2 centre = body.frame().position();
        double reach = reach(body);
        return obstacles.stream()
                .filter(obstacle -> obstacle.pose().position().distanceTo(centre)
                        <= reach + obstacle.shape().boundingRadius())
                .filter(obstacle -> !isClear(body, ObstacleGeometry.near(obstacle, centre, reach)))
                .map(Obstacle::id)
                .findFirst();
    }
}
