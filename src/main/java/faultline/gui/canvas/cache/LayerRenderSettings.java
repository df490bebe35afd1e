package faultline.gui.canvas.cache;

import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.Optional;

/**
 * The settings with which the content of a layer is rendered to an image; the scale is that of device pixels per pixel.
 */
public record LayerRenderSettings(Camera camera, Palette palette, double deviceScale) {

    /** An offset that differs by less than this from whole pixels is rounded to them. */
    private static final double ROUNDING = 1e-6;

    Rectangle bounds() {
        return camera.bounds();
    }

    /**
     * Returns the offset of the image, pixels, that gives the image with other settings; empty if a shift is not
     * enough.
     */
    Optional<Point> offsetTo(LayerRenderSettings other) {
        Camera to = other.camera;
        double dx = (camera.x() - to.x()) * camera.scale();
        double dy = (to.y() - camera.y()) * camera.scale();
        boolean whole = Math.abs(dx - Math.rint(dx)) < ROUNDING
                && Math.abs(dy - Math.rint(dy)) < ROUNDING
                && deviceScale == Math.rint(deviceScale);
        boolean near = Math.abs(dx) < camera.width() && Math.abs(dy) < camera.height();
        boolean alike = camera.scale() == to.scale()
                && bounds().equals(other.bounds())
                && deviceScale == other.deviceScale
                && palette.equals(other.palette);
        return alike && near && whole
                ? Optional.of(new Point((int) Math.rint(dx), (int) Math.rint(dy)))
                : Optional.empty();
    }
}
