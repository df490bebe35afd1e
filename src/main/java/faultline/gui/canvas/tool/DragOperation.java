package faultline.gui.canvas.tool;

import faultline.geometry.Angles;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.gui.edit.EditLimits;
import faultline.gui.edit.Rounding;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.AngleText;
import faultline.gui.text.Messages;
import faultline.paint.scene.ObstacleOutlines;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.WaypointPath;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/** An operation that computes the changes of a drag from the state at its start and the position of the mouse. */
public sealed interface DragOperation {

    /** Returns what the drag does while the mouse is at a point of the world. */
    DragPreview preview(Vector2 mouse, SnapSettings snap);

    /** Returns the commands that restore the state at the start. */
    default List<Command> restoreCommands() {
        return moveCommands(obstacles());
    }

    /** Returns the obstacles that the drag needs, in their state at the start. */
    default List<Obstacle> obstacles() {
        return List.of();
    }

    /** Returns this drag after a change of ids, which gives each obstacle the id that it has now. */
    default DragOperation renamed(UnaryOperator<Obstacle> named) {
        return this;
    }

    private static List<Command> moveCommands(List<Obstacle> to) {
        return to.stream()
                .<Command>map(obstacle -> new Command.MoveObstacle(obstacle.id(), obstacle.pose()))
                .toList();
    }

    /** Moves obstacles, given in their state at the start, without rotating them. The one under the mouse snaps. */
    record Move(Obstacle grabbed, List<Obstacle> obstacles, Vector2 grabPoint) implements DragOperation {

        public Move {
            obstacles = List.copyOf(obstacles);
        }

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 from = grabbed.pose().position();
            Vector2 to = snap.point(from, from.plus(mouse.minus(grabPoint)));
            Vector2 by = to.minus(from);
            List<Obstacle> there = obstacles.stream()
                    .map(obstacle -> obstacle.equals(grabbed)
                            ? movedTo(grabbed, to)
                            : movedTo(
                                    obstacle,
                                    Rounding.round(
                                            obstacle.pose().position(),
                                            obstacle.pose().position().plus(by))))
                    .toList();
            return new DragPreview(
                    moveCommands(there),
                    there,
                    Messages.get("value.place", ShapeHandles.formatMetres(to.x()), ShapeHandles.formatMetres(to.y())));
        }

        @Override
        public DragOperation renamed(UnaryOperator<Obstacle> named) {
            return new Move(named.apply(grabbed), obstacles.stream().map(named).toList(), grabPoint);
        }

        private static Obstacle movedTo(Obstacle obstacle, Vector2 place) {
            return obstacle.withPose(
                    new Pose(place.x(), place.y(), obstacle.pose().heading()));
        }
    }

    /**
     * Rotates obstacles, given in their state at the start, about their common centre. The heading of a single obstacle
     * snaps; for several, the angle of the turn snaps.
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
                    .map(obstacle -> obstacle.withPose(Rounding.round(
                            obstacle.pose(), ObstacleOutlines.rotatedPose(obstacle, middle, after - before))))
                    .toList();
            return new DragPreview(
                    moveCommands(there),
                    there,
                    Messages.get(obstacles.size() == 1 ? "value.heading" : "value.turn", AngleText.degrees(after, 1)));
        }

        @Override
        public DragOperation renamed(UnaryOperator<Obstacle> named) {
            return new Rotate(obstacles.stream().map(named).toList(), grabPoint);
        }
    }

    /**
     * Changes the size of an obstacle or one of its corners by the handle with an index in
     * {@link ShapeHandles#positions}.
     */
    record Resize(Obstacle obstacle, int handle) implements DragOperation {

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Obstacle there = ShapeHandles.dragHandle(obstacle, handle, mouse, snap);
            return new DragPreview(
                    List.of(new Command.PlaceObstacle(there)), List.of(there), ShapeHandles.sizeText(there, handle));
        }

        @Override
        public DragOperation renamed(UnaryOperator<Obstacle> named) {
            return new Resize(named.apply(obstacle), handle);
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
     * Moves a waypoint of an obstacle, which may be moving itself.
     *
     * @param start the obstacle at the start
     * @param index the index of the waypoint
     * @param expected returns the obstacle as it will be after all commands that have been sent
     */
    record MoveWaypoint(Obstacle start, int index, UnaryOperator<Obstacle> expected) implements DragOperation {

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 to = snap.point(start.motion().waypoints().get(index), mouse);
            return new DragPreview(
                    List.of(withWaypoint(to)),
                    List.of(),
                    Messages.get("value.place", ShapeHandles.formatMetres(to.x()), ShapeHandles.formatMetres(to.y())));
        }

        private Command withWaypoint(Vector2 waypoint) {
            Obstacle obstacle = expected.apply(start);
            WaypointPath motion = obstacle.motion();
            boolean samePath =
                    motion.waypoints().size() == start.motion().waypoints().size();
            List<Vector2> waypoints = new ArrayList<>((samePath ? motion : start.motion()).waypoints());
            waypoints.set(index, waypoint);
            return new Command.PlaceObstacle(obstacle.withMotion(motion.withWaypoints(waypoints)));
        }

        @Override
        public DragOperation renamed(UnaryOperator<Obstacle> named) {
            return new MoveWaypoint(named.apply(start), index, expected);
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(withWaypoint(start.motion().waypoints().get(index)));
        }

        @Override
        public List<Obstacle> obstacles() {
            return List.of(start);
        }
    }

    /**
     * Changes the range of a sensor by the arc of its cone; the robot may be driving.
     *
     * @param start the sensor at the start
     * @param expected the sensor as it will be after all commands that have been sent
     * @param current the present state of the sensor
     */
    record ChangeRange(SensorSpec start, Supplier<SensorSpec> expected, Supplier<SensorSnapshot> current)
            implements DragOperation {

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            double free = mouse.distanceTo(current.get().sector().apex());
            double rounded = Math.rint(snap.length(free) * 1000) / 1000;
            double range = Math.max(EditLimits.MIN_SENSOR_RANGE, Math.min(EditLimits.MAX_SENSOR_RANGE, rounded));
            return new DragPreview(
                    List.of(withRange(range)),
                    List.of(),
                    Messages.get("value.range", ShapeHandles.formatMetres(range)));
        }

        private Command withRange(double range) {
            return new Command.ConfigureSensor(expected.get().withRange(range));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(withRange(start.range()));
        }
    }

    /**
     * Changes the field of view of a sensor by an edge of its cone; the robot may be driving.
     *
     * @param start the sensor at the start
     * @param expected the sensor as it will be after all commands that have been sent
     * @param current the present state of the sensor
     */
    record ChangeCone(SensorSpec start, Supplier<SensorSpec> expected, Supplier<SensorSnapshot> current)
            implements DragOperation {

        /** In a narrower cone the two edges are too close for the mouse; a field of the panel can set such a cone. */
        private static final double MIN_DEGREES = 1;

        private static final double MAX_DEGREES = 179;
        private static final double STEPS_PER_DEGREE = 10;

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            Vector2 from = mouse.minus(current.get().sector().apex());
            double half =
                    Math.abs(Angles.difference(current.get().sector().axis().angle(), from.angle()));
            double free = Math.rint(Math.toDegrees(2 * half) * STEPS_PER_DEGREE) / STEPS_PER_DEGREE;
            double degrees =
                    Math.max(MIN_DEGREES, Math.min(MAX_DEGREES, snap.angleStep() > 0 ? Math.rint(free / 5) * 5 : free));
            return new DragPreview(
                    List.of(withCone(Degrees.toRadians(degrees))),
                    List.of(),
                    Messages.get("value.cone", String.format(Locale.ROOT, "%.1f", degrees)));
        }

        private Command withCone(double cone) {
            return new Command.ConfigureSensor(expected.get().withCone(cone));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(withCone(start.cone()));
        }
    }

    /**
     * Turns a sensor about its mounting point; the robot may be driving.
     *
     * @param start the sensor at the start
     * @param grip the angle from the axis of the cone to the point under the mouse, radians
     * @param expected the sensor as it will be after all commands that have been sent
     * @param current the present state of the sensor
     */
    record TurnSensor(SensorSpec start, double grip, Supplier<SensorSpec> expected, Supplier<SensorSnapshot> current)
            implements DragOperation {

        /** Returns the operation for a sensor, whose cone is under the mouse. */
        static TurnSensor at(Vector2 mouse, Supplier<SensorSpec> expected, Supplier<SensorSnapshot> current) {
            Sector cone = current.get().sector();
            return new TurnSensor(
                    expected.get(),
                    mouse.minus(cone.apex()).angle() - cone.axis().angle(),
                    expected,
                    current);
        }

        @Override
        public DragPreview preview(Vector2 mouse, SnapSettings snap) {
            SensorSnapshot now = current.get();
            double robotHeading = now.sector().axis().angle() - now.spec().bearing();
            double free = mouse.minus(now.sector().apex()).angle() - grip - robotHeading;
            double bearing = snap.angle(Angles.normalize(free));
            return new DragPreview(
                    List.of(withBearing(bearing)),
                    List.of(),
                    Messages.get("value.bearing", AngleText.degrees(bearing, 1)));
        }

        private Command withBearing(double bearing) {
            return new Command.ConfigureSensor(expected.get().withBearing(bearing));
        }

        @Override
        public List<Command> restoreCommands() {
            return List.of(withBearing(start.bearing()));
        }
    }
}
