package faultline.paint.surface;

import faultline.geometry.Vector2;

/**
 * A rectangle of a picture.
 *
 * @param x of its left edge, pixels
 * @param y of its upper edge, pixels
 * @param width pixels
 * @param height pixels
 */
public record PixelRectangle(double x, double y, double width, double height) {

    /**
     * The rectangle within this one.
     *
     * @param left how much less on the left, pixels
     * @param top how much less above, pixels
     * @param right how much less on the right, pixels
     * @param bottom how much less below, pixels
     * @return what is left
     */
    public PixelRectangle inset(double left, double top, double right, double bottom) {
        return new PixelRectangle(x + left, y + top, width - left - right, height - top - bottom);
    }

    /** The place at shares of the width from the left and of the height from below. */
    public Vector2 pointAt(double across, double up) {
        return new Vector2(x + across * width, y + (1 - up) * height);
    }
}
