package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** All obstacles as they stand now, the enclosing wall among them; mutable, on the world's thread. */
public final class ObstacleSet {

    /** The owner that stands for the enclosing wall. */
    private static final int ENCLOSURE_OWNER = -1;

    private final WorldSpec spec;
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<ObstacleGeometry> geometries = new ArrayList<>();
    private final List<Integer> movingIndices = new ArrayList<>();
    private final List<WaypointFollower> followers = new ArrayList<>();
    private SpatialIndex index = SpatialIndex.of(new CandidateBuffer());

    public ObstacleSet(WorldSpec spec) {
        this.spec = spec;
        spec.obstacles().forEach(this::append);
        rebuildIndex();
    }

    private void append(Obstacle obstacle) {
        obstacles.add(obstacle);
        geometries.add(ObstacleGeometry.of(obstacle));
        if (obstacle.isMoving()) {
            movingIndices.add(obstacles.size() - 1);
            followers.add(
                    new WaypointFollower(obstacle.motion(), obstacle.pose().position()));
        }
    }

    private void rebuildIndex() {
        CandidateBuffer all = new CandidateBuffer();
        collectStatic(all);
        index = SpatialIndex.of(all);
    }

    /** Adds every static figure. */
    public void collectStatic(CandidateBuffer all) {
        if (spec.enclosed()) {
            enclosureSides().forEach(side -> all.add(side, ENCLOSURE_OWNER));
        }
        for (int i = 0; i < obstacles.size(); i++) {
            if (!obstacles.get(i).isMoving()) {
                for (ConvexShape part : geometries.get(i).parts()) {
                    all.add(part, i);
                }
            }
        }
    }

    private List<Segment> enclosureSides() {
        double w = spec.width();
        double h = spec.height();
        return List.of(
                new Segment(0, 0, w, 0), new Segment(w, 0, w, h), new Segment(w, h, 0, h), new Segment(0, h, 0, 0));
    }

    /** All obstacles as they stand now, in drawing order. */
    List<Obstacle> obstacles() {
        return obstacles;
    }

    /** The place of an obstacle in {@link #obstacles()}, or -1. */
    int indexOf(String id) {
        for (int i = 0; i < obstacles.size(); i++) {
            if (obstacles.get(i).id().equals(id)) {
                return i;
            }
        }
        return -1;
    }

    /** The obstacle of an id as it stands now. */
    Optional<Obstacle> obstacle(String id) {
        int at = indexOf(id);
        return at < 0 ? Optional.empty() : Optional.of(obstacles.get(at));
    }

    /** The id of a candidate's owner. */
    String idOf(int owner) {
        return owner == ENCLOSURE_OWNER
                ? WorldSpec.ENCLOSURE
                : obstacles.get(owner).id();
    }

    /** The greatest angle of incidence that a candidate's owner sends light back from, radians. */
    double specularAngle(int owner) {
        return owner == ENCLOSURE_OWNER ? Obstacle.MATT : obstacles.get(owner).specularAngle();
    }

    /** Adds the static figures near a point, and perhaps others. */
    void findStaticNear(double x, double y, double distance, CandidateBuffer found) {
        index.findNear(x, y, distance, found);
    }

    /** Adds all figures near a point, moving ones last. */
    void findNear(double x, double y, double distance, CandidateBuffer found) {
        findStaticNear(x, y, distance, found);
        for (int owner : movingIndices) {
            for (ConvexShape part : geometries.get(owner).parts()) {
                found.add(part, owner);
            }
        }
    }

    /** The places in {@link #obstacles()} of those that move. */
    List<Integer> movingIndices() {
        return movingIndices;
    }

    /** The way of a moving obstacle, by its place in {@link #movingIndices()}. */
    WaypointFollower follower(int which) {
        return followers.get(which);
    }

    ObstacleGeometry geometry(int owner) {
        return geometries.get(owner);
    }

    /** Takes a moving obstacle to where its mover has come. */
    void updatePosition(int which) {
        int owner = movingIndices.get(which);
        Obstacle obstacle = obstacles.get(owner);
        Obstacle moved = obstacle.withPose(
                obstacle.pose().withPosition(followers.get(which).position()));
        obstacles.set(owner, moved);
        geometries.set(owner, ObstacleGeometry.of(moved));
    }

    /** Whether a point lies inside a solid obstacle. */
    boolean isInsideSolid(Vector2 point) {
        for (ObstacleGeometry outline : geometries) {
            if (outline.contains(point)) {
                return true;
            }
        }
        return false;
    }

    /** Adds an obstacle, or exchanges the one of its id in its place. */
    void put(Obstacle obstacle) {
        int at = indexOf(obstacle.id());
        List<Obstacle> all = new ArrayList<>(obstacles);
        if (at < 0) {
            all.add(obstacle);
        } else {
            all.set(at, obstacle);
        }
        replaceObstacles(all, obstacle.id());
    }

    /** Takes an obstacle away. */
    void remove(int at) {
        List<Obstacle> all = new ArrayList<>(obstacles);
        Obstacle gone = all.remove(at);
        replaceObstacles(all, gone.id());
    }

    /** Puts an obstacle somewhere else; one that moves goes on from there. */
    void move(int at, Pose pose) {
        Obstacle moved = obstacles.get(at).withPose(pose);
        obstacles.set(at, moved);
        geometries.set(at, ObstacleGeometry.of(moved));
        int which = movingIndices.indexOf(at);
        if (which < 0) {
            rebuildIndex();
        } else {
            followers.get(which).moveTo(pose);
        }
    }

    /** Builds the field anew from a changed list; movers keep their way, the changed one only if it is the same. */
    private void replaceObstacles(List<Obstacle> all, String changed) {
        List<String> ids =
                movingIndices.stream().map(owner -> obstacles.get(owner).id()).toList();
        List<WaypointFollower> kept = List.copyOf(followers);
        obstacles.clear();
        geometries.clear();
        movingIndices.clear();
        followers.clear();
        all.forEach(this::append);
        for (int i = 0; i < movingIndices.size(); i++) {
            int before = ids.indexOf(obstacles.get(movingIndices.get(i)).id());
            if (before >= 0) {
                followers.set(
                        i,
                        ids.get(before).equals(changed)
                                ? kept.get(before).replacedBy(followers.get(i))
                                : kept.get(before));
            }
        }
        rebuildIndex();
    }

    /** Whether a body is clear of an outline by more than a hair. */
    static boolean isClear(OrientedBox body, ObstacleGeometry outline) {
        for (ConvexShape part : outline.parts()) {
            if (BoxDistance.between(body, part).distance() <= Clearance.MIN_DISTANCE) {
                return false;
            }
        }
        return !outline.contains(body.frame().position());
    }

    /** The id of something that a body is not clear of, or an empty text. */
    String findObstruction(OrientedBox body) {
        if (spec.enclosed()) {
            for (Segment side : enclosureSides()) {
                if (BoxDistance.between(body, side).distance() <= Clearance.MIN_DISTANCE) {
                    return WorldSpec.ENCLOSURE;
                }
            }
        }
        for (int i = 0; i < obstacles.size(); i++) {
            if (!isClear(body, geometries.get(i))) {
                return obstacles.get(i).id();
            }
        }
        return "";
    }
}
