package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.gui.canvas.cache.CachedLayer;
import faultline.gui.canvas.cache.FrameBudget;
import faultline.gui.canvas.cache.GroundLayer;
import faultline.gui.canvas.cache.LayerRenderSettings;
import faultline.gui.canvas.cache.PathLayer;
import faultline.gui.canvas.tool.CanvasModel;
import faultline.gui.canvas.tool.DragGesture;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.scene.CornerChoice;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.scene.PathStyle;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.ReferenceOverlayPainter;
import faultline.paint.scene.ScenePainter;
import faultline.paint.scene.SelectionPainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.world.Snapshot;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;

/**
 * Paints frames, with the ground and the paths cached as images. A few selected obstacles are not part of the cached
 * ground, so that moving them is cheap; many selected ones, and large ones such as floor plans, stay in it.
 */
final class CachedSceneRenderer {

    private final CachedLayer<GroundLayer> ground = new CachedLayer<>();
    private final CachedLayer<PathLayer> path = new CachedLayer<>();
    private final CachedLayer<PathLayer> referencePath = new CachedLayer<>();
    private final CornerChoice captionCorner = ReferenceOverlayPainter.createCornerChoice();
    private final LongSupplier clock;
    private FrameBudget budget;
    private boolean complete = true;
    private ObstacleDivision division = ObstacleDivision.NONE;
    private ObstacleGroup selected = ObstacleGroup.NONE;
    /** Null before the first frame. */
    private Snapshot shownWorld;

    /** Creates a renderer with a clock, in nanoseconds, that limits the time to paint a frame. */
    CachedSceneRenderer(LongSupplier clock) {
        this.clock = clock;
        budget = new FrameBudget(clock);
    }

    /**
     * Paints the frame of a scene, which must have one, at the resolution of the device of the graphics;
     * {@code covered} will be hidden, pixels.
     */
    void paint(Graphics2D graphics, Camera camera, Palette palette, CanvasModel scene, List<Rectangle2D> covered) {
        Frame frame = scene.frame().orElseThrow();
        Set<Layer> layers = scene.layers();
        LayerRenderSettings view =
                new LayerRenderSettings(camera, palette, graphics.getTransform().getScaleX());
        ScenePainter painter = new ScenePainter(layers, LocalizedLabels.create());
        Set<String> apart = separatelyPainted(scene);
        division = division.of(frame.snapshot().obstacles(), apart);
        Set<String> marked = apart.isEmpty() ? scene.selection().get() : Set.of();
        PathLayer driven = new PathLayer(frame.path(), PathStyle.of(layers));
        Optional<ReferenceOverlay> reference = scene.referenceOverlay().get();
        discardObsoleteImages(frame.snapshot(), reference.isPresent());
        updateGround(new GroundLayer(frame.snapshot(), division.ground(), marked, painter), view);
        ground.draw(graphics, camera);
        if (layers.contains(Layer.PATH)) {
            updatePath(path, driven, view);
            reference.ifPresent(earlier ->
                    updatePath(referencePath, new PathLayer(earlier.run().path(), PathStyle.REFERENCE), view));
            reference.ifPresent(earlier -> referencePath.draw(graphics, camera));
            path.draw(graphics, camera);
        }
        DrawContext context = new DrawContext(graphics, camera, palette).withFont(LocalizedLabels.font());
        reference.ifPresent(earlier -> ReferenceOverlayPainter.paintRobot(context, earlier, frame.snapshot()));
        painter.paintDynamic(
                context,
                frame,
                division.separate(),
                driven.tailStart(path.shownContent().orElse(null)));
        paintSelection(context, scene);
        painter.paintScaleBar(context);
        if (scene.isCollisionReported()) {
            painter.paintCollisionReport(context, frame.snapshot(), covered);
        }
        reference.ifPresent(earlier ->
                ReferenceOverlayPainter.paintAnnotations(context, earlier, frame.snapshot(), captionCorner, covered));
    }

    /** Otherwise the image of the last world would be shown until that of a new, large one is complete. */
    private void discardObsoleteImages(Snapshot world, boolean hasReference) {
        if (!hasReference) {
            referencePath.clear();
        }
        if (shownWorld != null && (shownWorld.width() != world.width() || shownWorld.height() != world.height())) {
            ground.clear();
            path.clear();
        }
        shownWorld = world;
    }

    private void updateGround(GroundLayer wanted, LayerRenderSettings view) {
        budget = new FrameBudget(clock);
        ground.update(wanted, view, budget);
        complete = ground.isComplete();
    }

    /** Updates a path once the ground, and the path before it, are complete. */
    private void updatePath(CachedLayer<PathLayer> layer, PathLayer wanted, LayerRenderSettings view) {
        complete = complete && !budget.isSpent();
        if (complete) {
            layer.update(wanted, view, budget);
            complete = layer.isComplete();
        }
    }

    /** Returns the selected obstacles that are not part of the ground: all, or none if there is much to paint. */
    private static Set<String> separatelyPainted(CanvasModel scene) {
        Set<String> selection = scene.selection().get();
        return DragGesture.isPreviewedInFull(scene.selected()) ? selection : Set.of();
    }

    private void paintSelection(DrawContext context, CanvasModel scene) {
        division.separate().stream()
                .filter(scene::isSelected)
                .forEach(obstacle -> SelectionPainter.paintOutline(context, obstacle));
        scene.singleSelected()
                .ifPresent(
                        obstacle -> SelectionPainter.paintHandles(context, obstacle, ShapeHandles.positions(obstacle)));
        if (scene.selection().get().size() > 1) {
            selected = selected.with(scene.selected());
            SelectionPainter.paintHandle(context, selected);
        }
        scene.selectedSensor().ifPresent(sensor -> SelectionPainter.paintCone(context, sensor.sector()));
    }

    /** Returns whether everything was painted; if not, the frame must be painted again soon. */
    boolean isComplete() {
        return complete;
    }
}
