package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.gui.canvas.cache.CachedLayer;
import faultline.gui.canvas.cache.FrameBudget;
import faultline.gui.canvas.cache.GroundLayer;
import faultline.gui.canvas.cache.LayerBuffer;
import faultline.gui.canvas.cache.PathLayer;
import faultline.gui.canvas.tool.CanvasModel;
import faultline.gui.canvas.tool.DragGesture;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.scene.Layer;
import faultline.paint.scene.PathStyle;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.ReferenceOverlayPainter;
import faultline.paint.scene.ScenePainter;
import faultline.paint.scene.SelectionPainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;

/**
 * Paints frames with the ground and the path kept as images. A few selected obstacles are no part of the ground, so
 * that a hand may move them cheaply; where many are selected, they stay in it.
 */
final class CachedSceneRenderer {

    private final CachedLayer<GroundLayer> ground = new CachedLayer<>();
    private final CachedLayer<PathLayer> path = new CachedLayer<>();
    private final CachedLayer<PathLayer> referencePath = new CachedLayer<>();
    private final LongSupplier clock;
    private FrameBudget budget;
    private boolean complete = true;

    /** A picture that looks at a clock, nanoseconds, to see when a frame has taken long enough. */
    CachedSceneRenderer(LongSupplier clock) {
        this.clock = clock;
        budget = new FrameBudget(clock);
    }

    /** Paints a frame at the resolution of the device that the graphics belongs to. */
    void paint(Graphics2D graphics, Camera camera, Palette palette, Set<Layer> layers, Frame frame, CanvasModel scene) {
        LayerBuffer.View view =
                new LayerBuffer.View(camera, palette, graphics.getTransform().getScaleX());
        ScenePainter painter = new ScenePainter(layers, LocalizedLabels.create());
        Set<String> apart = scene.selection().get().size() <= DragGesture.MAX_SEPARATE_PREVIEWS
                ? scene.selection().get()
                : Set.of();
        Map<Boolean, List<Obstacle>> byLife = frame.snapshot().obstacles().stream()
                .collect(Collectors.partitioningBy(obstacle -> obstacle.isMoving() || apart.contains(obstacle.id())));
        Set<String> marked = apart.isEmpty() ? scene.selection().get() : Set.of();
        PathLayer driven = new PathLayer(frame.path(), PathStyle.RUN);
        Optional<ReferenceOverlay> ghost = scene.referenceOverlay().get();
        if (ghost.isEmpty()) {
            referencePath.clear();
        }
        updateGround(new GroundLayer(frame.snapshot(), byLife.get(false), marked, painter), view);
        ground.draw(graphics, camera);
        if (layers.contains(Layer.PATH)) {
            updatePath(path, driven, view);
            ghost.ifPresent(earlier ->
                    updatePath(referencePath, new PathLayer(earlier.run().path(), PathStyle.REFERENCE), view));
            ghost.ifPresent(earlier -> referencePath.draw(graphics, camera));
            path.draw(graphics, camera);
        }
        DrawContext brush = new DrawContext(graphics, camera, palette).withFont(LocalizedLabels.font());
        ghost.ifPresent(earlier -> ReferenceOverlayPainter.paintRobot(brush, earlier, frame.snapshot()));
        painter.paintDynamic(brush, frame, byLife.get(true), driven.tailStart(path.shownContent()));
        byLife.get(true).stream()
                .filter(scene::isSelected)
                .forEach(obstacle -> SelectionPainter.paintOutline(brush, obstacle));
        paintHandles(brush, scene);
        painter.paintOverlays(brush, frame.snapshot());
        ghost.ifPresent(earlier -> ReferenceOverlayPainter.paintAnnotations(brush, earlier));
    }

    private void updateGround(GroundLayer wanted, LayerBuffer.View view) {
        budget = new FrameBudget(clock);
        ground.update(wanted, view, budget);
        complete = ground.isComplete();
    }

    /** A path waits for the ground, and for the path before it. */
    private void updatePath(CachedLayer<PathLayer> layer, PathLayer wanted, LayerBuffer.View view) {
        complete = complete && !budget.isSpent();
        if (complete) {
            layer.update(wanted, view, budget);
            complete = layer.isComplete();
        }
    }

    private static void paintHandles(DrawContext brush, CanvasModel scene) {
        scene.singleSelected()
                .ifPresent(
                        obstacle -> SelectionPainter.paintHandles(brush, obstacle, ShapeHandles.positions(obstacle)));
        if (scene.selection().get().size() > 1) {
            SelectionPainter.paintHandle(brush, scene.selected());
        }
        scene.selectedSensor().ifPresent(sensor -> SelectionPainter.paintCone(brush, sensor.sector()));
    }

    /** Whether all was painted; if not, the picture must be painted again soon. */
    boolean isComplete() {
        return complete;
    }
}
