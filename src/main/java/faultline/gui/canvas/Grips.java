package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.Camera;
import faultline.paint.SelectionPainter;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.Cursor;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;

/** Says what the hand would take hold of at a place of the picture, and how the cursor tells so. */
final class Grips {

    private static final double REACH = SelectionPainter.HANDLE_RADIUS + Hold.CLICK;

    private final Scene scene;
    private final Viewpoint viewpoint;
    private final Courier courier;
    private final Watchers watchers;

    Grips(Scene scene, Viewpoint viewpoint, Courier courier, Watchers watchers) {
        this.scene = scene;
        this.viewpoint = viewpoint;
        this.courier = courier;
        this.watchers = watchers;
    }

    /** What a button takes hold of, with or without Shift and a wish to turn. */
    Hold take(Vec at, boolean left, boolean turns, boolean shift) {
        if (left && !shift) {
            Optional<Drag> handle = handle(at);
            if (handle.isPresent()) {
                return drag(handle.get(), at);
            }
        }
        Optional<Obstacle> under = ObstacleFinder.at(camera(), scene.obstacles(), at);
        if (under.isPresent()) {
            return left && shift ? toggled(under.get(), at) : obstacle(under.get(), turns, at);
        }
        Optional<Snapshot> robot = restingRobot(at);
        if (robot.isPresent()) {
            return new StartHold(robot.get(), turns, at, viewpoint, watchers);
        }
        return left && shift ? new BandHold(scene, viewpoint, at) : new PanHold(viewpoint, at, left ? () -> click(at) : () -> { });
    }

    private Optional<Drag> handle(Vec at) {
        if (turner().filter(place -> place.distanceTo(at) <= REACH).isPresent()) {
            return Optional.of(new Drag.Turn(scene.selected(), camera().toWorld(at)));
        }
        Optional<Obstacle> single = scene.single();
        OptionalInt handle = single.map(obstacle -> resizer(obstacle, at)).orElse(OptionalInt.empty());
        return handle.isPresent() ? Optional.of(new Drag.Resize(single.orElseThrow(), handle.getAsInt()))
                : scene.selectedSensor().flatMap(s -> cone(s, at));
    }

    /** Where the handle is that turns what is selected. */
    private Optional<Vec> turner() {
        List<Obstacle> selected = scene.selected();
        return selected.isEmpty() ? Optional.empty() : Optional.of(selected.size() == 1 ? SelectionPainter.handle(camera(), selected.get(0))
                : SelectionPainter.handle(camera(), selected));
    }

    private OptionalInt resizer(Obstacle obstacle, Vec at) {
        List<Vec> places = ShapeHandles.places(obstacle).stream().map(camera()::toScreen).toList();
        return IntStream.range(0, places.size()).filter(i -> places.get(i).distanceTo(at) <= REACH).findFirst();
    }

    private Optional<Drag> cone(SensorSnapshot sensor, Vec at) {
        String id = sensor.spec().id();
        if (Cones.isOnRim(camera(), sensor.sector(), at)) {
            return Optional.of(new Drag.Rim(sensor.spec(), () -> scene.sensor(id).orElse(sensor)));
        }
        boolean edge = Cones.isOnEdge(camera(), sensor.sector(), at);
        return edge ? Optional.of(new Drag.Edge(sensor.spec(), () -> scene.sensor(id).orElse(sensor))) : Optional.empty();
    }

    private Hold toggled(Obstacle obstacle, Vec at) {
        scene.toggle(obstacle.id());
        return new PanHold(viewpoint, at, () -> { });
    }

    private Hold obstacle(Obstacle obstacle, boolean turns, Vec at) {
        if (!scene.isSelected(obstacle)) {
            scene.select(Set.of(obstacle.id()));
        }
        Vec grip = camera().toWorld(at);
        return drag(turns ? new Drag.Turn(scene.selected(), grip) : new Drag.Move(obstacle, scene.selected(), grip), at);
    }

    private Hold drag(Drag drag, Vec at) {
        return new DragHold(drag, at, scene, viewpoint, courier);
    }

    /** The world, where its robot is at a place and has not set out yet. */
    private Optional<Snapshot> restingRobot(Vec at) {
        return scene.frame().map(frame -> frame.world()).filter(world -> watchers.areStartsWanted() && world.tick() == 0 && isOnRobot(world, at));
    }

    private boolean isOnRobot(Snapshot world, Vec at) {
        Vec local = world.pose().toLocal(camera().toWorld(at));
        return Math.abs(local.x()) <= world.robot().length() / 2 && Math.abs(local.y()) <= world.robot().width() / 2;
    }

    private void click(Vec at) {
        scene.select(Set.of());
        scene.sensor().set(Cones.at(camera(), scene.sensors(), at).map(sensor -> sensor.spec().id()));
    }

    /** The shape of the cursor that says what a press of the left button would do. */
    int cursor(Vec at) {
        if (handle(at).isPresent()) {
            return Cursor.HAND_CURSOR;
        }
        boolean movable = ObstacleFinder.at(camera(), scene.obstacles(), at).isPresent() || restingRobot(at).isPresent();
        return movable ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR;
    }

    private Camera camera() {
        return viewpoint.camera().get();
    }
}
