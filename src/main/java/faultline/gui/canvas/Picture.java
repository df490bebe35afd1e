package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.Ghost;
import faultline.paint.GhostPainter;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.PathStyle;
import faultline.paint.ScenePainter;
import faultline.paint.SelectionPainter;
import faultline.world.Obstacle;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;

/**
 * Paints frames with the ground and the path kept as images. A few selected obstacles are no part of the ground, so that a hand may
 * move them cheaply; where many are selected, they stay in it.
 */
final class Picture {

    /** So many obstacles can be painted with each frame. */
    static final int FEW = 16;

    private final KeptLayer<GroundMotif> ground = new KeptLayer<>();
    private final KeptLayer<PathMotif> path = new KeptLayer<>();
    private final KeptLayer<PathMotif> ghostPath = new KeptLayer<>();
    private final LongSupplier clock;
    private Effort effort;
    private boolean complete = true;

    /** A picture that looks at a clock, nanoseconds, to see when a frame has taken long enough. */
    Picture(LongSupplier clock) {
        this.clock = clock;
        effort = new Effort(clock);
    }

    /** Paints a frame at the resolution of the device that the graphics belongs to. */
    void paint(Graphics2D graphics, Camera camera, Palette palette, Set<Layer> layers, Frame frame, Scene scene) {
        LayerImage.View view = new LayerImage.View(camera, palette, graphics.getTransform().getScaleX());
        ScenePainter painter = new ScenePainter(layers, PictureWords.spoken());
        Set<String> apart = scene.selection().get().size() <= FEW ? scene.selection().get() : Set.of();
        Map<Boolean, List<Obstacle>> byLife = frame.world().obstacles().stream().collect(Collectors.partitioningBy(
                obstacle -> obstacle.motion().isPresent() || apart.contains(obstacle.id())));
        Set<String> marked = apart.isEmpty() ? scene.selection().get() : Set.of();
        PathMotif driven = new PathMotif(frame.path(), PathStyle.RUN);
        Optional<Ghost> ghost = scene.ghost().get();
        if (ghost.isEmpty()) {
            ghostPath.clear();
        }
        bringGround(new GroundMotif(frame.world(), byLife.get(false), marked, painter), view);
        ground.show(graphics, camera);
        if (layers.contains(Layer.PATH)) {
            bring(path, driven, view);
            ghost.ifPresent(earlier -> bring(ghostPath, new PathMotif(earlier.run().path(), PathStyle.GHOST), view));
            ghost.ifPresent(earlier -> ghostPath.show(graphics, camera));
            path.show(graphics, camera);
        }
        Brush brush = new Brush(graphics, camera, palette).lettered(PictureWords.font());
        ghost.ifPresent(earlier -> GhostPainter.paintBeneath(brush, earlier, frame.world()));
        painter.paintLive(brush, frame, byLife.get(true), driven.tailFrom(path.shown()));
        byLife.get(true).stream().filter(scene::isSelected).forEach(obstacle -> SelectionPainter.paintOutline(brush, obstacle));
        paintHandles(brush, scene);
        painter.paintMargin(brush, frame.world());
        ghost.ifPresent(earlier -> GhostPainter.paintAbove(brush, earlier));
    }

    private void bringGround(GroundMotif wanted, LayerImage.View view) {
        effort = new Effort(clock);
        ground.bring(wanted, view, effort);
        complete = ground.isComplete();
    }

    /** A path waits for the ground, and for the path before it. */
    private void bring(KeptLayer<PathMotif> layer, PathMotif wanted, LayerImage.View view) {
        complete = complete && !effort.isSpent();
        if (complete) {
            layer.bring(wanted, view, effort);
            complete = layer.isComplete();
        }
    }

    private static void paintHandles(Brush brush, Scene scene) {
        scene.single().ifPresent(obstacle -> SelectionPainter.paintHandles(brush, obstacle, ShapeHandles.places(obstacle)));
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
