package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.gui.edit.ShapeHandles;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.Ghost;
import faultline.paint.GhostPainter;
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
 * Paints frames with the ground and the path kept as images. The selected obstacles are never part of the ground, so that a hand may
 * move them cheaply.
 */
final class Picture {

    private final GroundLayer ground = new GroundLayer();
    private final PathLayer path = new PathLayer();
    private boolean complete = true;

    /** Paints a frame at the resolution of the device that the graphics belongs to. */
    void paint(Graphics2D graphics, Camera camera, Palette palette, Set<Layer> layers, Frame frame, Scene scene) {
        LayerImage.View view = new LayerImage.View(camera, palette, graphics.getTransform().getScaleX());
        ScenePainter painter = new ScenePainter(layers);
        Map<Boolean, List<Obstacle>> byLife = frame.world().obstacles().stream().collect(Collectors.partitioningBy(
                obstacle -> obstacle.motion().isPresent() || scene.isSelected(obstacle)));
        ground.image(view, painter, frame, byLife.get(false)).show(graphics);
        complete = true;
        if (layers.contains(Layer.PATH)) {
            path.image(view, frame.path()).show(graphics);
            complete = path.isComplete();
        }
        Brush brush = new Brush(graphics, camera, palette);
        Optional<Ghost> ghost = scene.ghost().get();
        ghost.ifPresent(earlier -> GhostPainter.paintRobot(brush, earlier, frame.world().robot(), frame.world().time()));
        painter.paintLive(brush, frame, byLife.get(true), path.tailFrom());
        ghost.ifPresent(earlier -> GhostPainter.paintDivergence(brush, earlier));
        paintSelection(brush, scene);
        painter.paintMargin(brush, frame.world());
        ghost.ifPresent(earlier -> GhostPainter.paintCaption(brush, earlier));
    }

    private static void paintSelection(Brush brush, Scene scene) {
        scene.selected().forEach(obstacle -> SelectionPainter.paintOutline(brush, obstacle));
        scene.single().ifPresent(obstacle -> SelectionPainter.paintHandles(brush, obstacle, ShapeHandles.places(obstacle)));
        scene.selectedSensor().ifPresent(sensor -> SelectionPainter.paintCone(brush, sensor.sector()));
    }

    /** Whether all was painted; if not, the picture must be painted again soon. */
    boolean isComplete() {
        return complete;
    }
}
