package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;

/**
 * What part of the world a picture shows: the one place where metres with y up become pixels with y down, and back.
 *
 * @param x of the world point in the middle of the picture, metres
 * @param y of the world point in the middle of the picture, metres
 * @param scale pixels per metre, in [{@link #MIN_SCALE}, {@link #MAX_SCALE}]
 * @param width of the picture, pixels, positive
 * @param height of the picture, pixels, positive
 */
public record Camera(double x, double y, double scale, int width, int height) {

    /** The farthest zoom out: a kilometre on a screen. */
    public static final double MIN_SCALE = 1;

    /** The farthest zoom in: a pole of 1 mm is 20 pixels wide. */
    public static final double MAX_SCALE = 20_000;

    public Camera {
        if (!(Double.isFinite(x)
                && Double.isFinite(y)
                && scale >= MIN_SCALE
                && scale <= MAX_SCALE
                && width > 0
                && height > 0)) {
            throw new IllegalArgumentException("not a camera: centre " + x + ", " + y + ", " + scale
                    + " pixels per metre, " + width + " x " + height + " pixels");
        }
    }

    /**
     * The camera that shows a part of the world as large as it fits, in the middle.
     *
     * @param bounds metres
     * @param margin to be left free on every side, pixels
     * @param width of the picture, pixels, positive
     * @param height of the picture, pixels, positive
     * @return the camera
     */
    public static Camera fit(Rectangle2D bounds, double margin, int width, int height) {
        double across = Math.max(1, width - 2 * margin) / bounds.getWidth();
        double up = Math.max(1, height - 2 * margin) / bounds.getHeight();
        return new Camera(bounds.getCenterX(), bounds.getCenterY(), clampScale(Math.min(across, up)), width, height);
    }

    /**
     * Returns the camera that shows a part of the world as large as it fits in the middle of an area of a picture.
     *
     * @param bounds metres
     * @param area pixels; the picture ends at its lower right corner
     * @return the camera
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

    /**
     * Where a point of the world is in the picture.
     *
     * @param world metres, y up
     * @return pixels from the upper left corner, y down
     */
    public Vector2 toScreen(Vector2 world) {
        return new Vector2(width / 2.0 + scale * (world.x() - x), height / 2.0 - scale * (world.y() - y));
    }

    /**
     * What point of the world is at a place of the picture.
     *
     * @param screen pixels from the upper left corner, y down
     * @return metres, y up
     */
    public Vector2 toWorld(Vector2 screen) {
        return new Vector2(x + (screen.x() - width / 2.0) / scale, y - (screen.y() - height / 2.0) / scale);
    }

    /**
     * The transform that {@link #toScreen(Vector2)} applies.
     *
     * @return a new transform from the world to the picture
     */
    public AffineTransform transform() {
        return new AffineTransform(scale, 0, 0, -scale, width / 2.0 - scale * x, height / 2.0 + scale * y);
    }

    /**
     * The whole picture.
     *
     * @return pixels, from the upper left corner
     */
    public Rectangle bounds() {
        return new Rectangle(width, height);
    }

    /**
     * The part of the world that the picture shows.
     *
     * @return metres; its y and height as in the world, so that y is the lower edge
     */
    public Rectangle2D visibleArea() {
        return new Rectangle2D.Double(x - width / scale / 2, y - height / scale / 2, width / scale, height / scale);
    }

    /**
     * This camera zoomed so that one place of the picture goes on showing the same point of the world.
     *
     * @param screen the place, pixels
     * @param factor above 1 to zoom in, below 1 to zoom out; limited at the ends of the scale
     * @return the zoomed camera
     */
    public Camera zoomedAbout(Vector2 screen, double factor) {
        double zoomed = clampScale(scale * factor);
        Vector2 still = toWorld(screen);
        double keep = scale / zoomed;
        return new Camera(
                still.x() + (x - still.x()) * keep, still.y() + (y - still.y()) * keep, zoomed, width, height);
    }

    /**
     * This camera moved so that the picture's content follows a dragging hand.
     *
     * @param dx how far the content goes to the right, pixels
     * @param dy how far the content goes down, pixels
     * @return the moved camera
     */
    public Camera panned(double dx, double dy) {
        return new Camera(x - dx / scale, y + dy / scale, scale, width, height);
    }

    /**
     * This camera for a picture of another size; the middle and the scale stay.
     *
     * @param newWidth pixels, positive
     * @param newHeight pixels, positive
     * @return the camera
     */
    public Camera resized(int newWidth, int newHeight) {
        return new Camera(x, y, scale, newWidth, newHeight);
    }
}
