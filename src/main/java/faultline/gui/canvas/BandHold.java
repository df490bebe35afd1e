package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Snap;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import faultline.paint.ObstacleOutlines;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashSet;
import java.util.Set;

/** A rubber band: the obstacles that lie wholly in it are selected besides the others. */
final class BandHold implements Hold {

    private final Scene scene;
    private final Viewpoint viewpoint;
    private final Vec from;
    private Vec to;

    BandHold(Scene scene, Viewpoint viewpoint, Vec pressed) {
        this.scene = scene;
        this.viewpoint = viewpoint;
        this.from = pressed;
        this.to = pressed;
    }

    @Override
    public void to(Vec screen, Snap snap) {
        to = screen;
    }

    @Override
    public void release() {
        Rectangle2D band = new Rectangle2D.Double();
        Vec a = viewpoint.camera().get().toWorld(from);
        Vec b = viewpoint.camera().get().toWorld(to);
        band.setFrameFromDiagonal(a.x(), a.y(), b.x(), b.y());
        Set<String> wanted = new LinkedHashSet<>(scene.selection().get());
        scene.obstacles().stream().filter(obstacle -> band.contains(ObstacleOutlines.inWorld(obstacle).getBounds2D()))
                .forEach(obstacle -> wanted.add(obstacle.id()));
        scene.select(wanted);
    }

    @Override
    public void paint(Brush brush) {
        HandPainter.paintBand(brush, from, to);
    }
}
