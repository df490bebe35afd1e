package faultline.gui.canvas.cache;

import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.scene.ObstaclePainter;
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
 * The ground and the still obstacles on it, in drawing order, some of which are marked as selected. Its first piece is
 * everything beneath the obstacles.
 */
public record GroundLayer(Snapshot world, List<Obstacle> obstacles, Set<String> marked, ScenePainter painter)
        implements LayerContent<GroundLayer> {

    /** The number of obstacles without labels that a frame has time for. */
    private static final double OBSTACLES_PER_FRAME = 200;

    /** The number of obstacles painted as dots that a frame has time for. */
    private static final double DOTS_PER_FRAME = 4000;

    /** The cost of everything beneath the obstacles, as a fraction of a frame. */
    private static final double BACKDROP_COST = 0.1;

    private static final double LABEL_COST = 1;
    /** The number of filled pixels that cost as much as the fixed cost of an obstacle. */
    private static final double PIXELS_PER_OBSTACLE = 4000;
    /** The number of corners that cost as much as the fixed cost of an obstacle. */
    private static final double CORNERS_PER_OBSTACLE = 36;
    /** If more obstacles have changed, everything is repainted. */
    private static final int MAX_CHANGES = 16;

    @Override
    public boolean isOpaque() {
        return true;
    }

    @Override
    public int pieceCount() {
        return 1 + obstacles.size();
    }

    /** Large obstacles, such as floor plans, are painted in parts, each of which takes about a frame. */
    @Override
    public int bandCount() {
        return obstacles.stream().mapToInt(this::frameCount).max().orElse(1);
    }

    /** Returns the number of frames that it takes to paint the corners of an obstacle, at least one. */
    private int frameCount(Obstacle obstacle) {
        double obstaclesWorth =
                outlineCount(obstacle) * ObstacleOutlines.cornerCount(obstacle.shape()) / CORNERS_PER_OBSTACLE;
        return Math.max(1, (int) Math.ceil(obstaclesWorth / OBSTACLES_PER_FRAME));
    }

    /** Returns how often the outline of an obstacle is painted: once more if it is marked. */
    private int outlineCount(Obstacle obstacle) {
        return marked.contains(obstacle.id()) ? 2 : 1;
    }

    @Override
    public int paint(DrawContext context, Rectangle clip, int from, FrameBudget budget) {
        if (from == 0) {
            painter.paintBackground(context, world);
            budget.spend(BACKDROP_COST
                    * clip.width
                    * clip.height
                    / (context.camera().width() * context.camera().height()));
        }
        ObstaclePainter obstaclePainter = painter.obstaclePainter();
        int next = Math.max(1, from);
        for (; next < pieceCount() && !budget.isSpent(); next++) {
            Obstacle obstacle = obstacles.get(next - 1);
            if (obstaclePainter.isDot(context.camera(), obstacle)) {
                paint(obstaclePainter, context, obstacle);
                budget.spend(1 / DOTS_PER_FRAME);
                continue;
            }
            Rectangle2D extent = obstaclePainter.bounds(context.camera(), obstacle);
            if (extent.intersects(clip)) {
                paint(obstaclePainter, context, obstacle);
                budget.spend(cost(obstacle, extent, clip) / OBSTACLES_PER_FRAME);
            }
        }
        return next;
    }

    private void paint(ObstaclePainter obstaclePainter, DrawContext context, Obstacle obstacle) {
        obstaclePainter.paint(context, obstacle);
        if (marked.contains(obstacle.id())) {
            SelectionPainter.paintOutline(context, obstacle);
        }
    }

    /** Returns the cost of what the clip shows of an obstacle, in obstacles. */
    private double cost(Obstacle obstacle, Rectangle2D extent, Rectangle clip) {
        double pixels = area(extent);
        double shown = area(extent.createIntersection(clip));
        double corners = ObstacleOutlines.cornerCount(obstacle.shape()) * shown / pixels;
        return outlineCount(obstacle) * (1 + corners / CORNERS_PER_OBSTACLE)
                + (painter.obstaclePainter().named() ? LABEL_COST : 0)
                + shown / PIXELS_PER_OBSTACLE;
    }

    private static double area(Rectangle2D rectangle) {
        return rectangle.getWidth() * rectangle.getHeight();
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
        boolean patchable = changed.size() <= 2 * MAX_CHANGES
                && changed.stream().allMatch(obstacle -> frameCount(obstacle) == 1)
                && isSameOrder(before, now, earlier);
        return patchable ? Optional.of(new Patch(extents(changed, camera), 0)) : Optional.empty();
    }

    private boolean isRepaintNeeded(Obstacle obstacle, Map<String, Obstacle> elsewhere, GroundLayer earlier) {
        return !obstacle.equals(elsewhere.get(obstacle.id()))
                || marked.contains(obstacle.id()) != earlier.marked.contains(obstacle.id());
    }

    /** Returns whether the obstacles that exist before and after are in the same order. */
    private boolean isSameOrder(Map<String, Obstacle> before, Map<String, Obstacle> now, GroundLayer earlier) {
        List<String> ids =
                obstacles.stream().map(Obstacle::id).filter(before::containsKey).toList();
        return ids.equals(earlier.obstacles.stream()
                .map(Obstacle::id)
                .filter(now::containsKey)
                .toList());
    }

    private List<Rectangle> extents(List<Obstacle> changed, Camera camera) {
        ObstaclePainter obstaclePainter = painter.obstaclePainter();
        return changed.stream()
                .map(obstacle ->
                        obstaclePainter.bounds(camera, obstacle).getBounds().intersection(camera.bounds()))
                .toList();
    }

    private static Map<String, Obstacle> byId(List<Obstacle> obstacles) {
        Map<String, Obstacle> byId = new HashMap<>();
        obstacles.forEach(obstacle -> byId.put(obstacle.id(), obstacle));
        return byId;
    }
}
