package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.DrawContext;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashSet;
import java.util.Set;

/** A rubber band that adds the obstacles wholly inside it to the selection. */
public final class RubberBandGesture implements Gesture {

    private final CanvasModel model;
    private final Viewport viewport;
    private final Vector2 from;
    private Vector2 to;

    public RubberBandGesture(CanvasModel model, Viewport viewport, Vector2 pressed) {
        this.model = model;
        this.viewport = viewport;
        this.from = pressed;
        this.to = pressed;
    }

    @Override
    public void moveTo(Vector2 screen, SnapSettings snap) {
        to = screen;
    }

    @Override
    public void release() {
        Rectangle2D band = new Rectangle2D.Double();
        Vector2 a = viewport.camera().get().toWorld(from);
        Vector2 b = viewport.camera().get().toWorld(to);
        band.setFrameFromDiagonal(a.x(), a.y(), b.x(), b.y());
        Set<String> wanted = new LinkedHashSet<>(model.selection().get());
        model.obstacles().stream()
                .filter(obstacle ->
                        band.contains(ObstacleOutlines.worldShape(obstacle).getBounds2D()))
                .forEach(obstacle -> wanted.add(obstacle.id()));
        model.select(wanted);
    }

    @Override
    public void paint(DrawContext context) {
        InteractionPainter.paintRubberBand(context, from, to);
    }
}
