package faultline.paint;

import faultline.engine.Frame;
import faultline.world.Obstacle;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Paints a frame from three parts, one on top of the other: the ground with the obstacles that stand still, the path, and all that lives.
 * Whoever paints many frames may keep the first two as pictures.
 *
 * @param layers the layers that show
 * @param words the words in the picture
 */
public record ScenePainter(Set<Layer> layers, Words words) {

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
    public void paint(Brush brush, Frame frame, Optional<Ghost> ghost) {
        Predicate<Obstacle> moves = obstacle -> obstacle.motion().isPresent();
        List<Obstacle> obstacles = frame.world().obstacles();
        paintBackdrop(brush, frame.world());
        obstacles.stream().filter(moves.negate()).forEach(obstacle -> paintStill(brush, obstacle));
        ghost.ifPresent(earlier -> paintGhost(brush, earlier, frame.world()));
        paintLive(brush, frame, obstacles.stream().filter(moves).toList(), 0);
        paintMargin(brush, frame.world());
        ghost.ifPresent(earlier -> GhostPainter.paintAbove(brush, earlier));
    }

    private void paintGhost(Brush brush, Ghost ghost, Snapshot world) {
        if (layers.contains(Layer.PATH)) {
            GhostPainter.paintPath(brush, ghost);
        }
        GhostPainter.paintBeneath(brush, ghost, world);
    }

    /**
     * Paints what lies beneath all obstacles: the canvas, the grid, and the edge of the world.
     *
     * @param brush where to
     * @param world the world
     */
    public void paintBackdrop(Brush brush, Snapshot world) {
        brush.fill(brush.camera().bounds(), brush.palette().canvas());
        if (layers.contains(Layer.GRID)) {
            GridPainter.paint(brush);
        }
        BoundsPainter.paint(brush, world);
    }

    /**
     * Paints an obstacle without its route.
     *
     * @param brush where to
     * @param obstacle the obstacle
     */
    public void paintStill(Brush brush, Obstacle obstacle) {
        ObstaclePainter.paint(brush, obstacle);
        if (showsNames()) {
            ObstaclePainter.paintName(brush.lettered(words.font()), obstacle);
        }
    }

    /**
     * Where an obstacle leaves marks, its route apart.
     *
     * @param camera through which it is looked at
     * @param obstacle the obstacle
     * @return pixels; its outline and its name are wholly inside
     */
    public Rectangle2D extent(Camera camera, Obstacle obstacle) {
        return ObstaclePainter.extent(camera, obstacle, showsNames() ? Optional.of(words.font()) : Optional.empty());
    }

    /**
     * Whether obstacles are painted with their names.
     *
     * @return true where {@link Layer#LABELS} shows
     */
    public boolean showsNames() {
        return layers.contains(Layer.LABELS);
    }

    /**
     * Paints what changes from frame to frame.
     *
     * @param brush where to
     * @param frame the frame
     * @param obstacles those that were not painted with the ground
     * @param pathFrom the index of the first point of the path that is not painted yet, or of the last that is; from 0 to its size - 1
     */
    public void paintLive(Brush brush, Frame frame, List<Obstacle> obstacles, int pathFrom) {
        Snapshot world = frame.world();
        if (layers.contains(Layer.PATH)) {
            PathPainter.paintTail(brush, frame.path(), pathFrom, world.pose().position());
        }
        obstacles.forEach(obstacle -> paintMoving(brush, obstacle));
        paintSensors(brush, world.sensors());
        RobotPainter.paint(brush, world.robot(), world.pose());
        if (layers.contains(Layer.HITS)) {
            world.sensors().forEach(sensor -> HitPainter.paint(brush, sensor.hits()));
        }
        CollisionPainter.paint(brush, world);
    }

    /**
     * Paints what belongs to the picture and not to the world, on top of all.
     *
     * @param brush where to
     * @param world the world
     */
    public void paintMargin(Brush brush, Snapshot world) {
        if (layers.contains(Layer.SCALE_BAR)) {
            ScaleBarPainter.paint(brush.lettered(words.font()));
        }
        world.collision().ifPresent(collision -> CollisionPainter.paintBadge(brush.lettered(words.font()), collision, words));
    }

    private void paintMoving(Brush brush, Obstacle obstacle) {
        if (layers.contains(Layer.ROUTES)) {
            obstacle.motion().ifPresent(motion -> RoutePainter.paint(brush.lettered(words.font()), motion));
        }
        paintStill(brush, obstacle);
    }

    private void paintSensors(Brush brush, List<SensorSnapshot> sensors) {
        if (!layers.contains(Layer.CONES)) {
            return;
        }
        for (int i = 0; i < sensors.size(); i++) {
            SensorPainter.paintCone(brush, i, sensors.get(i));
        }
        for (int i = 0; i < sensors.size(); i++) {
            SensorPainter.paintLabels(brush.lettered(words.font()), i, sensors.get(i), words);
        }
    }
}
