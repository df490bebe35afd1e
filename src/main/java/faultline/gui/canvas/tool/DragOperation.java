package faultline.gui.canvas.tool;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.Messages;
import faultline.paint.scene.ObstacleOutlines;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;

/**
 * What a hand that holds a mouse button does: it starts from where things and the mouse were, and goes where the mouse
 * goes.
 */
public sealed interface DragOperation {

    /** What is wanted while the mouse is over a point of the world. */
    DragPreview preview(Vector2 mouse, SnapSettings snap);

    /** What brings all back to how it was at the start. */
    List<Command> restoreCommands();

    /** The obstacles without which it cannot go on, as they stood at the start. */
    default List<Obstacle> obstacles() {
        return List.of();
    }

    private static List<Command> moveCommands(List<Obstacle> to) {
        return to.stream()
                .<Command>map(obstacle -> new Command.MoveObstacle(obstacle.id(), obstacle.pose()))
                .toList();
    }

    /**
     * Moves obstacles without turning them.
     *
     * @param grabbed the one that the mouse took; it is what snaps
     * @param obstacles all of them as they stood at the start
     * @param grabPoint where the mouse took it, metres
     */
    record Move(Obstacle grabbed, List<Obstacle> obstacles, Vector2 grabPoint) implements DragOperation {

        public Move {
            obstacles = List.copyOf(obstacles);
        }

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 from = grabbed.pose().position();
            Vector2 to = snap.point(from.plus(mouse.minus(grabPoint)));
            Vector2 by = to.minus(from);
            List<Obstacle> there = obstacles.stream()
                    .map(obstacle -> obstacle.equals(grabbed)
                            ? movedTo(grabbed, to)
                            : movedTo(obstacle, obstacle.pose().position().plus(by)))
                    .toList();
            return new DragPreview(
                    moveCommands(there),
                    there,
                    Messages.get("value.place", ShapeHandles.formatMetres(to.x()), ShapeHandles.formatMetres(to.y())));
        }

        private static Obstacle movedTo(Obstacle obstacle, Vector2 place) {
            return obstacle.withPose(
                    new Pose(place.x(), place.y(), obstacle.pose().heading()));
        }

        @Override
        public List<Command> restoreCommands() {
            return moveCommands(obstacles);
        }
    }

    /**
     * Turns obstacles about their common middle. Of a single one the heading snaps, of several the turn.
     *
     * @param obstacles as they stood at the start, at least one
     * @param grabPoint where the mouse took them, metres
     */
    record Rotate(List<Obstacle> obstacles, Vector2 grabPoint) implements DragOperation {

        public Rotate {
            obstacles = List.copyOf(obstacles);
        }

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 middle = ObstacleOutlines.centre(obstacles);
            double before = obstacles.size() == 1 ? obstacles.get(0).pose().heading() : 0;
            double after = snap.angle(before
                    + mouse.minus(middle).angle()
                    - grabPoint.minus(middle).angle());
            List<Obstacle> there = obstacles.stream()
                    .map(obstacle -> obstacle.withPose(ObstacleOutlines.rotatedPose(obstacle, middle, after - before)))
                    .toList();
            String degrees = String.format(Locale.ROOT, "%.1f", Math.toDegrees(Math.IEEEremainder(after, 2 * Math.PI)));
            return new DragPreview(
                    moveCommands(there),
                    there,
                    Messages.get(obstacles.size() == 1 ? "value.heading" : "value.turn", degrees));
        }

        @Override
        public List<Command> restoreCommands() {
            return moveCommands(obstacles);
        }
    }

    /**
     * Changes an obstacle's size or one of its corners.
     *
     * @param obstacle as it was at the start
     * @param handle its place in {@link ShapeHandles#positions}
     */
    record Resize(Obstacle obstacle, int handle) implements DragOperation {

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Obstacle there = ShapeHandles.dragHandle(obstacle, handle, mouse, snap);
            return new DragPreview(
                    List.of(new Command.PlaceObstacle(there)), List.of(there), ShapeHandles.sizeText(there, handle));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(new Command.PlaceObstacle(obstacle));
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
     * @param current the sensor as it is; the robot may be driving
     */
    record ChangeRange(SensorSpec spec, Supplier<SensorSnapshot> current) implements DragOperation {

        private static final double MIN_RANGE = 0.01;
        private static final double MAX_RANGE = 100;

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            double free = mouse.distanceTo(current.get().sector().apex());
            double range = Math.max(MIN_RANGE, Math.min(MAX_RANGE, Math.rint(snap.length(free) * 1000) / 1000));
            return new DragPreview(
                    List.of(new Command.ConfigureSensor(spec.withRange(range))),
                    List.of(),
                    Messages.get("value.range", ShapeHandles.formatMetres(range)));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(new Command.ConfigureSensor(spec));
        }
    }

    /**
     * Changes the field of view of a sensor by an edge of its cone.
     *
     * @param spec as it was at the start
     * @param current the sensor as it is; the robot may be driving
     */
    record ChangeCone(SensorSpec spec, Supplier<SensorSnapshot> current) implements DragOperation {

        private static final double MIN_DEGREES = 1;
        private static final double MAX_DEGREES = 179;
        private static final double STEPS_PER_DEGREE = 10;

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 from = mouse.minus(current.get().sector().apex());
            double half = Math.abs(Math.IEEEremainder(
                    from.angle() - current.get().sector().axis().angle(), 2 * Math.PI));
            double free = Math.rint(Math.toDegrees(2 * half) * STEPS_PER_DEGREE) / STEPS_PER_DEGREE;
            double degrees =
                    Math.max(MIN_DEGREES, Math.min(MAX_DEGREES, snap.angleStep() > 0 ? Math.rint(free / 5) * 5 : free));
            SensorSpec tuned = spec.withCone(Degrees.toRadians(degrees));
            return new DragPreview(
                    List.of(new Command.ConfigureSensor(tuned)),
                    List.of(),
                    Messages.get("value.cone", String.format(Locale.ROOT, "%.1f", degrees)));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(new Command.ConfigureSensor(spec));
        }
    }
}
