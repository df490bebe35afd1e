package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;

/**
 * The part of the world that a picture shows: the one place where metres, y up, are converted to pixels, y down, and
 * back.
 *
 * @param x the x coordinate of the world point in the middle of the picture, metres
 * @param y the y coordinate of the world point in the middle of the picture, metres
 * @param scale pixels per metre, in [{@link #MIN_SCALE}, {@link #MAX_SCALE}]
 * @param width the width of the picture, pixels, positive
 * @param height the height of the picture, pixels, positive
 */
public record Camera(double x, double y, double scale, int width, int height) {

    /** The smallest scale: a world of 100 km fits on a screen. */
    public static final double MIN_SCALE = 0.005;

    /** The greatest scale: a pole of 1 mm is 20 pixels wide. */
    public static final double MAX_SCALE = 20_000;

    public Camera {
        if (!(Double.isFinite(x)
                && Double.isFinite(y)
                && scale >= MIN_SCALE
                && scale <= MAX_SCALE
                && width > 0
                && height > 0)) {
            throw new IllegalArgumentException("invalid camera: centre " + x + ", " + y + ", " + scale
                    + " pixels per metre, " + width + " x " + height + " pixels");
        }
    }

    /**
     * Returns the camera that shows a part of the world, metres, as large as possible in the middle of a picture of the
     * given size, pixels, with a margin on every side.
     */
    public static Camera fit(Rectangle2D bounds, double margin, int width, int height) {
        double across = Math.max(1, width - 2 * margin) / bounds.getWidth();
        double up = Math.max(1, height - 2 * margin) / bounds.getHeight();
        return new Camera(bounds.getCenterX(), bounds.getCenterY(), clampScale(Math.min(across, up)), width, height);
    }

    /**
     * Returns the camera that shows a part of the world, metres, as large as possible in the middle of an area of a
     * picture that ends at the lower right corner of the area.
     */
    public static Camera fit(Rectangle2D bounds, PixelRectangle area) {
        double scale = clampScale(Math.min(area.width() / bounds.getWidth(), area.height() / bounds.getHeight()));
        int width = (int) Math.ceil(area.x() + area.width());
        int height = (int) Math.ceil(area.y() + area.height());
        return new Camera(
                bounds.getCenterX() - (area.x() + (area.width() - width) / 2) / scale,
                bounds.getCenterY() + (area.y() + (area.height() - height) / 2) / scale,
                scale,
                width,
                height);
    }

    private static double clampScale(double scale) {
        return Math.max(MIN_SCALE, Math.min(MAX_SCALE, scale));
    }

    /** Returns the position of a world point, metres, in the picture, pixels. */
    public Vector2 toScreen(Vector2 world) {
        return new Vector2(width / 2.0 + scale * (world.x() - x), height / 2.0 - scale * (world.y() - y));
    }

    /** Returns the world point, metres, at a position in the picture, pixels. */
    public Vector2 toWorld(Vector2 screen) {
        return new Vector2(x + (screen.x() - width / 2.0) / scale, y - (screen.y() - height / 2.0) / scale);
    }

    /** Returns a new transform that maps points as {@link #toScreen(Vector2)} does. */
    public AffineTransform transform() {
        return new AffineTransform(scale, 0, 0, -scale, width / 2.0 - scale * x, height / 2.0 + scale * y);
    }

    /** Returns the bounds of the picture, pixels. */
    public Rectangle bounds() {
        return new Rectangle(width, height);
    }

    /** Returns the part of the world that the picture shows, metres; y is the lower edge. */
    public Rectangle2D visibleArea() {
        return new Rectangle2D.Double(x - width / scale / 2, y - height / scale / 2, width / scale, height / scale);
    }

    /**
     * Returns this camera zoomed about a fixed position in the picture, pixels; the factor is above 1 to zoom in, and
     * limited at the ends of the scale.
     */
    public Camera zoomedAbout(Vector2 screen, double factor) {
        double zoomed = clampScale(scale * factor);
        Vector2 still = toWorld(screen);
        double keep = scale / zoomed;
        return new Camera(
                still.x() + (x - still.x()) * keep, still.y() + (y - still.y()) * keep, zoomed, width, height);
    }

    /** Returns this camera moved so that the content moves by dx to the right and dy down, pixels. */
    public Camera panned(double dx, double dy) {
        return new Camera(x - dx / scale, y + dy / scale, scale, width, height);
    }

    /** Returns this camera for a picture of another size with the same middle and scale. */
    public Camera resized(int newWidth, int newHeight) {
        return new Camera(x, y, scale, newWidth, newHeight);
    }
}
