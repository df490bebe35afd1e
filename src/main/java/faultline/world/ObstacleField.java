package faultline.world;

import faultline.geometry.Box;
import faultline.geometry.BoxGap;
import faultline.geometry.Convex;
import faultline.geometry.Pose;
import faultline.geometry.Segment;
import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** All obstacles as they stand now, the enclosing wall among them; mutable, on the world's thread. */
final class ObstacleField {

    /** The owner that stands for the enclosing wall. */
    private static final int ENCLOSURE = -1;

    private final WorldSpec spec;
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Outline> outlines = new ArrayList<>();
    private final List<Integer> moving = new ArrayList<>();
    private final List<Mover> movers = new ArrayList<>();
    private FigureIndex index = FigureIndex.over(new Candidates());

    ObstacleField(WorldSpec spec) {
        this.spec = spec;
        spec.obstacles().forEach(this::append);
        rebuild();
    }

    private void append(Obstacle obstacle) {
        obstacles.add(obstacle);
        outlines.add(Outline.of(obstacle));
        obstacle.motion().ifPresent(motion -> {
            moving.add(obstacles.size() - 1);
            movers.add(new Mover(motion, obstacle.pose().position()));
        });
    }

    private void rebuild() {
        Candidates all = new Candidates();
        allStatic(all);
        index = FigureIndex.over(all);
    }

    /** Adds every static figure. */
    void allStatic(Candidates all) {
        if (spec.enclosed()) {
            enclosure().forEach(side -> all.add(side, ENCLOSURE));
        }
        for (int i = 0; i < obstacles.size(); i++) {
            if (obstacles.get(i).motion().isEmpty()) {
                for (Convex part : outlines.get(i).parts()) {
                    all.add(part, i);
                }
            }
        }
    }

    private List<Segment> enclosure() {
        double w = spec.width();
        double h = spec.height();
        return List.of(new Segment(0, 0, w, 0), new Segment(w, 0, w, h), new Segment(w, h, 0, h), new Segment(0, h, 0, 0));
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
        return owner == ENCLOSURE ? WorldSpec.ENCLOSURE : obstacles.get(owner).id();
    }

    /** The greatest angle of incidence that a candidate's owner sends light back from, radians. */
    double specular(int owner) {
        return owner == ENCLOSURE ? Obstacle.MATT : obstacles.get(owner).specular();
    }

    /** Adds the static figures near a point, and perhaps others. */
    void staticNear(double x, double y, double distance, Candidates found) {
        index.near(x, y, distance, found);
    }

    /** Adds all figures near a point, moving ones last. */
    void allNear(double x, double y, double distance, Candidates found) {
        staticNear(x, y, distance, found);
        for (int owner : moving) {
            for (Convex part : outlines.get(owner).parts()) {
                found.add(part, owner);
            }
        }
    }

    /** The places in {@link #obstacles()} of those that move. */
    List<Integer> moving() {
        return moving;
    }

    /** The way of a moving obstacle, by its place in {@link #moving()}. */
    Mover mover(int which) {
        return movers.get(which);
    }

    Outline outline(int owner) {
        return outlines.get(owner);
    }

    /** Takes a moving obstacle to where its mover has come. */
    void follow(int which) {
        int owner = moving.get(which);
        Obstacle obstacle = obstacles.get(owner);
        Vec place = movers.get(which).place();
        Obstacle moved = obstacle.at(new Pose(place.x(), place.y(), obstacle.pose().heading()));
        obstacles.set(owner, moved);
        outlines.set(owner, Outline.of(moved));
    }

    /** Whether a point lies inside a solid obstacle. */
    boolean insideSolid(Vec point) {
        for (Outline outline : outlines) {
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
        reset(all, obstacle.id());
    }

    /** Takes an obstacle away. */
    void remove(int at) {
        List<Obstacle> all = new ArrayList<>(obstacles);
        Obstacle gone = all.remove(at);
        reset(all, gone.id());
    }

    /** Puts an obstacle somewhere else; one that moves goes on from there. */
    void move(int at, Pose pose) {
        Obstacle moved = obstacles.get(at).at(pose);
        obstacles.set(at, moved);
        outlines.set(at, Outline.of(moved));
        int which = moving.indexOf(at);
        if (which < 0) {
            rebuild();
        } else {
            movers.get(which).moveTo(pose);
        }
    }

    /** Builds the field anew from a changed list; movers keep their way, the changed one only if it is the same. */
    private void reset(List<Obstacle> all, String changed) {
        List<String> ids = moving.stream().map(owner -> obstacles.get(owner).id()).toList();
        List<Mover> kept = List.copyOf(movers);
        obstacles.clear();
        outlines.clear();
        moving.clear();
        movers.clear();
        all.forEach(this::append);
        for (int i = 0; i < moving.size(); i++) {
            int before = ids.indexOf(obstacles.get(moving.get(i)).id());
            if (before >= 0) {
                movers.set(i, ids.get(before).equals(changed) ? kept.get(before).exchanged(movers.get(i)) : kept.get(before));
            }
        }
        rebuild();
    }

    /** Whether a body is clear of an outline by more than a hair. */
    static boolean isClear(Box body, Outline outline) {
        for (Convex part : outline.parts()) {
            if (BoxGap.between(body, part).distance() <= Clearance.LEAST) {
                return false;
            }
        }
        return !outline.contains(new Vec(body.cx(), body.cy()));
    }

    /** The id of something that a body is not clear of, or an empty text. */
    String obstructing(Box body) {
        if (spec.enclosed()) {
            for (Segment side : enclosure()) {
                if (BoxGap.between(body, side).distance() <= Clearance.LEAST) {
                    return WorldSpec.ENCLOSURE;
                }
            }
        }
        for (int i = 0; i < obstacles.size(); i++) {
            if (!isClear(body, outlines.get(i))) {
                return obstacles.get(i).id();
            }
        }
        return "";
    }
}
