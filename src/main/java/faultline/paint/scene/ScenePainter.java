package faultline.paint.scene;

import faultline.engine.Frame;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Set;

/**
 * Paints a frame in three parts, one on top of the other: the background with the static obstacles, the path, and
 * everything that changes. Callers that paint many frames may cache the first two.
 */
public record ScenePainter(Set<Layer> layers, SceneLabels labels) {

    public ScenePainter {
        layers = Set.copyOf(layers);
    }

    /** Paints a frame, beside reference runs. */
    public void paint(DrawContext context, Frame frame, List<ReferenceOverlay> references) {
        paintGround(context, frame.snapshot());
        paintAboveGround(context, frame, references);
    }

    /** Paints what lies beneath everything that changes without an edit: the background and the static obstacles. */
    public void paintGround(DrawContext context, Snapshot world) {
        paintBackground(context, world);
        staticObstacles(world).forEach(obstacle -> obstaclePainter().paint(context, obstacle));
    }

    /** Paints everything above the ground, beside reference runs. */
    public void paintAboveGround(DrawContext context, Frame frame, List<ReferenceOverlay> references) {
        Snapshot world = frame.snapshot();
        references.forEach(reference -> paintReference(context, reference, world));
        List<Obstacle> moving =
                world.obstacles().stream().filter(Obstacle::isMoving).toList();
        paintDynamic(context, frame, moving, 0);
        paintScaleBar(context);
        paintCollisionReport(context, world, List.of());
        references.forEach(reference -> ReferenceOverlayPainter.paintAnnotations(
                context, reference, world, ReferenceOverlayPainter.createCornerChoice(), List.of()));
    }

    /** Returns the obstacles that do not move, in drawing order. */
    public static List<Obstacle> staticObstacles(Snapshot world) {
        return world.obstacles().stream()
                .filter(obstacle -> !obstacle.isMoving())
                .toList();
    }

    private void paintReference(DrawContext context, ReferenceOverlay reference, Snapshot world) {
        if (layers.contains(Layer.PATH)) {
            ReferenceOverlayPainter.paintPath(context, reference);
        }
        ReferenceOverlayPainter.paintRobot(context, reference, world);
    }

    /** Paints what lies beneath all obstacles: the canvas, the grid, and the bounds of the world. */
    public void paintBackground(DrawContext context, Snapshot world) {
        context.fill(context.camera().bounds(), context.palette().canvas());
        if (layers.contains(Layer.GRID)) {
            GridPainter.paint(context);
        }
        BoundsPainter.paint(context, world.width(), world.height(), world.enclosed());
    }

    /** Returns what paints the obstacles without their routes. */
    public ObstaclePainter obstaclePainter() {
        return new ObstaclePainter(layers.contains(Layer.LABELS), labels.font());
    }

    /**
     * Paints what changes from frame to frame, with the obstacles that are not part of the background. {@code pathFrom}
     * is the index of the last point of the path that is already painted, or 0.
     */
    public void paintDynamic(DrawContext context, Frame frame, List<Obstacle> obstacles, int pathFrom) {
        Snapshot world = frame.snapshot();
        if (layers.contains(Layer.PATH)) {
            PathPainter.paintTail(
                    context,
                    frame.path(),
                    PathStyle.of(layers),
                    pathFrom,
                    world.pose().position());
        }
        List<SensorLabel> sensorLabels = sensorLabels(context, world);
        List<Rectangle2D> taken = sensorLabels.stream().map(SensorLabel::box).toList();
        obstacles.forEach(obstacle -> paintMovingObstacle(context, obstacle, taken));
        RobotPainter.paintHalo(context, world.robot(), world.pose());
        paintSensors(context, world.sensors(), sensorLabels);
        RobotPainter.paint(context, world.robot(), world.pose());
        RobotPainter.paintHeading(context, world.robot(), world.pose());
        MotorFaultPainter.paintWheels(context, world);
        if (layers.contains(Layer.INTERSECTIONS)) {
            paintIntersections(context, world.sensors());
        }
        MotorFaultPainter.paintLabels(context.withFont(labels.font()), world, labels, taken);
        CollisionPainter.paint(context, world);
    }

    /** Paints the scale bar, on top of the world. */
    public void paintScaleBar(DrawContext context) {
        if (layers.contains(Layer.SCALE_BAR)) {
            ScaleBarPainter.paint(context.withFont(labels.font()));
        }
    }

    /**
     * Paints the report of the first collision, if there was one, on top of the world, so that it can be seen beside
     * the areas that will be covered, pixels.
     */
    public void paintCollisionReport(DrawContext context, Snapshot world, List<Rectangle2D> covered) {
        if (world.collision().isPresent()) {
            CollisionPainter.paintBadge(context.withFont(labels.font()), world, labels, covered);
        }
    }

    /** Paints an obstacle with its route, whose speed does not cover the labels with some bounding boxes, pixels. */
    private void paintMovingObstacle(DrawContext context, Obstacle obstacle, List<Rectangle2D> taken) {
        if (layers.contains(Layer.ROUTES) && obstacle.isMoving()) {
            RoutePainter.paint(context.withFont(labels.font()), obstacle.motion(), taken);
        }
        obstaclePainter().paint(context, obstacle);
    }

    /** Returns the labels of the sensors, none without the cones. */
    private List<SensorLabel> sensorLabels(DrawContext context, Snapshot world) {
        return layers.contains(Layer.CONES)
                ? SensorLabel.of(context.withFont(labels.font()), world, labels)
                : List.of();
    }

    private void paintSensors(DrawContext context, List<SensorSnapshot> sensors, List<SensorLabel> sensorLabels) {
        if (layers.contains(Layer.CONES)) {
            for (int i = 0; i < sensors.size(); i++) {
                SensorPainter.paintCone(context, i, sensors.get(i));
            }
            sensors.forEach(sensor -> SensorPainter.paintTrueReading(context, sensor));
            DrawContext labelled = context.withFont(labels.font());
            sensorLabels.forEach(label -> label.paint(labelled));
        }
    }

    private static void paintIntersections(DrawContext context, List<SensorSnapshot> sensors) {
        for (int i = 0; i < sensors.size(); i++) {
            IntersectionPainter.paint(
                    context, sensors.get(i).intersections(), context.palette().sensorColours(i));
        }
    }
}
