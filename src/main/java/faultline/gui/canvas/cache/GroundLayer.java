package faultline.gui.canvas.cache;

import faultline.paint.scene.ScenePainter;
import faultline.paint.scene.SelectionPainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The ground with the obstacles that stand still on it. Its first piece is all that lies beneath them.
 *
 * @param world whose edge shows; nothing else of it does
 * @param obstacles that stand still, in drawing order
 * @param marked the ids of those that are marked as selected
 * @param painter of all that
 */
public record GroundLayer(Snapshot world, List<Obstacle> obstacles, Set<String> marked, ScenePainter painter)
        implements LayerContent<GroundLayer> {

    /** A frame has time for so many obstacles without names. */
    private static final double OBSTACLES_PER_FRAME = 200;

    /** What all that lies beneath the obstacles takes of a frame's time. */
    private static final double BACKDROP_COST = 0.1;

    private static final double LABEL_COST = 1;
    /** So many pixels cost as much to fill as an obstacle costs in any case. */
    private static final double PIXELS_PER_OBSTACLE = 4000;
    /** Where more obstacles than this have changed, all is painted anew. */
    private static final int MAX_CHANGES = 16;

    @Override
    public boolean isOpaque() {
        return true;
    }

    @Override
    public int pieceCount() {
        return 1 + obstacles.size();
    }

    @Override
    public int paint(DrawContext brush, Rectangle clip, int from, FrameBudget effort) {
        if (from == 0) {
            painter.paintBackground(brush, world);
            effort.spend(BACKDROP_COST
                    * clip.width
                    * clip.height
                    / (brush.camera().width() * brush.camera().height()));
        }
        int next = Math.max(1, from);
        for (; next < pieceCount() && !effort.isSpent(); next++) {
            Obstacle obstacle = obstacles.get(next - 1);
            Rectangle2D extent = painter.obstacleBounds(brush.camera(), obstacle);
            if (extent.intersects(clip)) {
                paint(brush, obstacle);
                effort.spend(cost(extent) / OBSTACLES_PER_FRAME);
            }
        }
        return next;
    }

    private void paint(DrawContext brush, Obstacle obstacle) {
        painter.paintObstacle(brush, obstacle);
        if (marked.contains(obstacle.id())) {
            SelectionPainter.paintOutline(brush, obstacle);
        }
    }

    private double cost(Rectangle2D extent) {
        double marks = marked.isEmpty() ? 1 : 2;
        return marks
                + (painter.showsLabels() ? LABEL_COST : 0)
                + extent.getWidth() * extent.getHeight() / PIXELS_PER_OBSTACLE;
    }

    @Override
    public boolean isSatisfiedBy(GroundLayer earlier) {
        return hasSameBackground(earlier) && obstacles.equals(earlier.obstacles) && marked.equals(earlier.marked);
    }

    private boolean hasSameBackground(GroundLayer other) {
        return painter.equals(other.painter)
                && world.width() == other.world.width()
                && world.height() == other.world.height()
                && world.enclosed() == other.world.enclosed();
    }

    @Override
    public Optional<Patch> patchSince(GroundLayer earlier, Camera camera) {
        if (!hasSameBackground(earlier)) {
            return Optional.empty();
        }
        Map<String, Obstacle> before = byId(earlier.obstacles);
        Map<String, Obstacle> now = byId(obstacles);
        List<Obstacle> changed = new ArrayList<>();
        earlier.obstacles.stream()
                .filter(obstacle -> isRepaintNeeded(obstacle, now, earlier))
                .forEach(changed::add);
        obstacles.stream()
                .filter(obstacle -> isRepaintNeeded(obstacle, before, earlier))
                .forEach(changed::add);
        boolean patchable = changed.size() <= 2 * MAX_CHANGES && isSameOrder(before, now, earlier);
        return patchable ? Optional.of(new Patch(extents(changed, camera), 0)) : Optional.empty();
    }

    private boolean isRepaintNeeded(Obstacle obstacle, Map<String, Obstacle> elsewhere, GroundLayer earlier) {
        return !obstacle.equals(elsewhere.get(obstacle.id()))
                || marked.contains(obstacle.id()) != earlier.marked.contains(obstacle.id());
    }

    /** Whether those that are there before and after lie on each other in the same way. */
    private boolean isSameOrder(Map<String, Obstacle> before, Map<String, Obstacle> now, GroundLayer earlier) {
        List<String> ids =
                obstacles.stream().map(Obstacle::id).filter(before::containsKey).toList();
        return ids.equals(earlier.obstacles.stream()
                .map(Obstacle::id)
                .filter(now::containsKey)
                .toList());
    }

    private List<Rectangle> extents(List<Obstacle> changed, Camera camera) {
        return changed.stream()
                .map(obstacle ->
                        painter.obstacleBounds(camera, obstacle).getBounds().intersection(camera.bounds()))
                .toList();
    }

    private static Map<String, Obstacle> byId(List<Obstacle> obstacles) {
        Map<String, Obstacle> byId = new HashMap<>();
        obstacles.forEach(obstacle -> byId.put(obstacle.id(), obstacle));
        return byId;
    }
}
