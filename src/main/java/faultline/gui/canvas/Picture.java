package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.ScenePainter;
import faultline.paint.SelectionPainter;
import faultline.world.Obstacle;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Paints frames with the ground and the path kept as images. The selected obstacle is never part of the ground, so that a hand may
 * move it cheaply.
 */
final class Picture {

    private final GroundLayer ground = new GroundLayer();
    private final PathLayer path = new PathLayer();
    private boolean complete = true;

    /** Paints a frame at the resolution of the device that the graphics belongs to. */
    void paint(Graphics2D graphics, Camera camera, Palette palette, Set<Layer> layers, Frame frame, Optional<Obstacle> selected) {
        LayerImage.View view = new LayerImage.View(camera, palette, graphics.getTransform().getScaleX());
        ScenePainter painter = new ScenePainter(layers);
        Map<Boolean, List<Obstacle>> byLife = frame.world().obstacles().stream().collect(Collectors.partitioningBy(
                obstacle -> obstacle.motion().isPresent() || selected.filter(obstacle::equals).isPresent()));
        ground.image(view, painter, frame, byLife.get(false)).show(graphics);
        complete = true;
        if (layers.contains(Layer.PATH)) {
            path.image(view, frame.path()).show(graphics);
            complete = path.isComplete();
        }
        Brush brush = new Brush(graphics, camera, palette);
        painter.paintLive(brush, frame, byLife.get(true), path.tailFrom());
        selected.ifPresent(obstacle -> SelectionPainter.paint(brush, obstacle));
        painter.paintMargin(brush, frame.world());
    }
    /** Whether all was painted; if not, the picture must be painted again soon. */
    boolean isComplete() {
        return complete;
    }
}
