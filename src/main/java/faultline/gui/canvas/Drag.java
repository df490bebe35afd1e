package faultline.gui.canvas;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.Snap;
import faultline.gui.text.Texts;
import faultline.paint.ObstacleOutlines;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;

/** What a hand that holds a mouse button does: it starts from where things and the mouse were, and goes where the mouse goes. */
sealed interface Drag {

    /** What is wanted while the mouse is over a point of the world. */
    Wish wanted(Vec mouse, Snap snap);

    /** What brings all back to how it was at the start. */
    List<Command> back();

    /** The obstacles without which it cannot go on, as they stood at the start. */
    default List<Obstacle> obstacles() {
        return List.of();
    }

    private static List<Command> moves(List<Obstacle> to) {
        return to.stream().<Command>map(obstacle -> new Command.MoveObstacle(obstacle.id(), obstacle.pose())).toList();
    }

    /**
     * Moves obstacles without turning them.
     *
     * @param held the one that the mouse took; it is what snaps
     * @param obstacles all of them as they stood at the start
     * @param grip where the mouse took it, metres
     */
    record Move(Obstacle held, List<Obstacle> obstacles, Vec grip) implements Drag {

        public Move {
            obstacles = List.copyOf(obstacles);
        }

        @Override
        public Wish wanted(Vec mouse, Snap snap) {
            Vec from = held.pose().position();
            Vec to = snap.place(from.plus(mouse.minus(grip)));
            Vec by = to.minus(from);
            List<Obstacle> there = obstacles.stream().map(obstacle -> obstacle.equals(held) ? at(held, to)
                    : at(obstacle, obstacle.pose().position().plus(by))).toList();
            return new Wish(moves(there), there, Texts.text("value.place", ShapeHandles.metres(to.x()), ShapeHandles.metres(to.y())));
        }

        private static Obstacle at(Obstacle obstacle, Vec place) {
            return obstacle.at(new Pose(place.x(), place.y(), obstacle.pose().heading()));
        }

        @Override
        public List<Command> back() {
            return moves(obstacles);
        }
    }

    /**
     * Turns obstacles about their common middle. Of a single one the heading snaps, of several the turn.
     *
     * @param obstacles as they stood at the start, at least one
     * @param grip where the mouse took them, metres
     */
    record Turn(List<Obstacle> obstacles, Vec grip) implements Drag {

        public Turn {
            obstacles = List.copyOf(obstacles);
        }

        @Override
        public Wish wanted(Vec mouse, Snap snap) {
            Vec middle = ObstacleOutlines.middle(obstacles);
            double before = obstacles.size() == 1 ? obstacles.get(0).pose().heading() : 0;
            double after = snap.angle(before + mouse.minus(middle).angle() - grip.minus(middle).angle());
            List<Obstacle> there = obstacles.stream()
                    .map(obstacle -> obstacle.at(ObstacleOutlines.turned(obstacle, middle, after - before))).toList();
            String degrees = String.format(Locale.ROOT, "%.1f", Math.toDegrees(Math.IEEEremainder(after, 2 * Math.PI)));
            return new Wish(moves(there), there, Texts.text(obstacles.size() == 1 ? "value.heading" : "value.turn", degrees));
        }

        @Override
        public List<Command> back() {
            return moves(obstacles);
        }
    }

    /**
     * Changes an obstacle's size or one of its corners.
     *
     * @param obstacle as it was at the start
     * @param handle its place in {@link ShapeHandles#places}
     */
    record Resize(Obstacle obstacle, int handle) implements Drag {

        @Override
        public Wish wanted(Vec mouse, Snap snap) {
            Obstacle there = ShapeHandles.dragged(obstacle, handle, mouse, snap);
            return new Wish(List.of(new Command.PutObstacle(there)), List.of(there), ShapeHandles.values(there, handle));
        }

        @Override
        public List<Command> back() {
            return List.of(new Command.PutObstacle(obstacle));
        }

        @Override
        public List<Obstacle> obstacles() {
            return List.of(obstacle);
        }
    }

    /**
     * Changes the range of a sensor by the rim of its cone.
     *
     * @param spec as it was at the start
     * @param now the sensor as it is; the robot may be driving
     */
    record Rim(SensorSpec spec, Supplier<SensorSnapshot> now) implements Drag {

        private static final double LEAST = 0.01;
        private static final double MOST = 100;

        @Override
        public Wish wanted(Vec mouse, Snap snap) {
            double free = mouse.distanceTo(now.get().sector().apex());
            double range = Math.max(LEAST, Math.min(MOST, Math.rint(snap.length(free) * 1000) / 1000));
            return new Wish(List.of(new Command.TuneSensor(spec.withRange(range))), List.of(), Texts.text("value.range", ShapeHandles.metres(range)));
        }

        @Override
        public List<Command> back() {
            return List.of(new Command.TuneSensor(spec));
        }
    }

    /**
     * Changes the field of view of a sensor by an edge of its cone.
     *
     * @param spec as it was at the start
     * @param now the sensor as it is; the robot may be driving
     */
    record Edge(SensorSpec spec, Supplier<SensorSnapshot> now) implements Drag {

        private static final double LEAST = 1;
        private static final double MOST = 179;
        private static final double TENTHS = 10;

        @Override
        public Wish wanted(Vec mouse, Snap snap) {
            Vec from = mouse.minus(now.get().sector().apex());
            double half = Math.abs(Math.IEEEremainder(from.angle() - now.get().sector().axis().angle(), 2 * Math.PI));
            double free = Math.rint(Math.toDegrees(2 * half) * TENTHS) / TENTHS;
            double degrees = Math.max(LEAST, Math.min(MOST, snap.turn() > 0 ? Math.rint(free / 5) * 5 : free));
            SensorSpec tuned = spec.withCone(Degrees.toRadians(degrees));
            return new Wish(List.of(new Command.TuneSensor(tuned)), List.of(), Texts.text("value.cone", String.format(Locale.ROOT, "%.1f", degrees)));
        }

        @Override
        public List<Command> back() {
            return List.of(new Command.TuneSensor(spec));
        }
    }
}
