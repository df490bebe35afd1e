package faultline.paint.scene;

import faultline.engine.Frame;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Paints a frame from three parts, one on top of the other: the ground with the obstacles that stand still, the path,
 * and all that lives. Whoever paints many frames may keep the first two as pictures.
 *
 * @param layers the layers that show
 * @param labels the words in the picture
 */
public record ScenePainter(Set<Layer> layers, SceneLabels labels) {

    public ScenePainter {
        layers = Set.copyOf(layers);
    }

    /**
     * Paints the whole of a frame.
     *
     * @param brush where to
     * @param frame the frame
     * @param ghost an earlier run beside it, empty for none
     */
    public void paint(DrawContext brush, Frame frame, Optional<ReferenceOverlay> ghost) {
        Predicate<Obstacle> moves = obstacle -> obstacle.motion().isPresent();
        List<Obstacle> obstacles = frame.snapshot().obstacles();
        paintBackground(brush, frame.snapshot());
        obstacles.stream().filter(moves.negate()).forEach(obstacle -> paintObstacle(brush, obstacle));
        ghost.ifPresent(earlier -> paintReference(brush, earlier, frame.snapshot()));
        paintDynamic(brush, frame, obstacles.stream().filter(moves).toList(), 0);
        paintOverlays(brush, frame.snapshot());
        ghost.ifPresent(earlier -> ReferenceOverlayPainter.paintAnnotations(brush, earlier));
    }

    private void paintReference(DrawContext brush, ReferenceOverlay ghost, Snapshot world) {
        if (layers.contains(Layer.PATH)) {
            ReferenceOverlayPainter.paintPath(brush, ghost);
        }
        ReferenceOverlayPainter.paintRobot(brush, ghost, world);
    }

    /**
     * Paints what lies beneath all obstacles: the canvas, the grid, and the edge of the world.
     *
     * @param brush where to
     * @param world the world
     */
    public void paintBackground(DrawContext brush, Snapshot world) {
        brush.fill(brush.camera().bounds(), brush.palette().canvas());
        if (layers.contains(Layer.GRID)) {
            GridPainter.paint(brush);
        }
        BoundsPainter.paint(brush, world.width(), world.height(), world.enclosed());
    }

    /**
     * Paints an obstacle without its route.
     *
     * @param brush where to
     * @param obstacle the obstacle
     */
    public void paintObstacle(DrawContext brush, Obstacle obstacle) {
        ObstaclePainter.paint(brush, obstacle);
        if (showsLabels()) {
            ObstaclePainter.paintName(brush.withFont(labels.font()), obstacle);
        }
    }

    /**
     * Where an obstacle leaves marks, its route apart.
     *
     * @param camera through which it is looked at
     * @param obstacle the obstacle
     * @return pixels; its outline and its name are wholly inside
     */
    public Rectangle2D obstacleBounds(Camera camera, Obstacle obstacle) {
        return ObstaclePainter.paintedBounds(
                camera, obstacle, showsLabels() ? Optional.of(labels.font()) : Optional.empty());
    }

    /**
     * Whether obstacles are painted with their names.
     *
     * @return true where {@link Layer#LABELS} shows
     */
    public boolean showsLabels() {
        return layers.contains(Layer.LABELS);
    }

    /**
     * Paints what changes from frame to frame.
     *
     * @param brush where to
     * @param frame the frame
     * @param obstacles those that were not painted with the ground
     * @param pathFrom the index of the first point of the path that is not painted yet, or of the last that is; from 0
     *     to its size - 1
     */
    public void paintDynamic(DrawContext brush, Frame frame, List<Obstacle> obstacles, int pathFrom) {
        Snapshot world = frame.snapshot();
        if (layers.contains(Layer.PATH)) {
            PathPainter.paintTail(brush, frame.path(), pathFrom, world.pose().position());
        }
        obstacles.forEach(obstacle -> paintMovingObstacle(brush, obstacle));
        paintSensors(brush, world.sensors());
        RobotPainter.paint(brush, world.robot(), world.pose());
        if (layers.contains(Layer.INTERSECTIONS)) {
            world.sensors().forEach(sensor -> IntersectionPainter.paint(brush, sensor.intersections()));
        }
        CollisionPainter.paint(brush, world);
    }

    /**
     * Paints what belongs to the picture and not to the world, on top of all.
     *
     * @param brush where to
     * @param world the world
     */
    public void paintOverlays(DrawContext brush, Snapshot world) {
        if (layers.contains(Layer.SCALE_BAR)) {
            ScaleBarPainter.paint(brush.withFont(labels.font()));
        }
        world.collision()
                .ifPresent(collision -> CollisionPainter.paintBadge(brush.withFont(labels.font()), collision, labels));
    }

    private void paintMovingObstacle(DrawContext brush, Obstacle obstacle) {
        if (layers.contains(Layer.ROUTES)) {
            obstacle.motion().ifPresent(motion -> RoutePainter.paint(brush.withFont(labels.font()), motion));
        }
        paintObstacle(brush, obstacle);
    }

    private void paintSensors(DrawContext brush, List<SensorSnapshot> sensors) {
        if (!layers.contains(Layer.CONES)) {
            return;
        }
        for (int i = 0; i < sensors.size(); i++) {
            SensorPainter.paintCone(brush, i, sensors.get(i));
        }
        for (int i = 0; i < sensors.size(); i++) {
            SensorPainter.paintLabels(brush.withFont(labels.font()), i, sensors.get(i), labels);
        }
    }
}
