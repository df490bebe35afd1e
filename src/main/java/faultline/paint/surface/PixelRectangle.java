package faultline.paint.surface;

import faultline.geometry.Vector2;

/**
 * A rectangle in a picture.
 *
 * @param x the x coordinate of its left edge, pixels
 * @param y the y coordinate of its upper edge, pixels
 * @param width pixels
 * @param height pixels
 */
public record PixelRectangle(double x, double y, double width, double height) {

    /** Returns this rectangle without margins, which are given in pixels. */
    public PixelRectangle inset(double left, double top, double right, double bottom) {
        return new PixelRectangle(x + left, y + top, width - left - right, height - top - bottom);
    }

    /** Returns the point at fractions of the width from the left and of the height from below. */
    public Vector2 pointAt(double across, double up) {
        return new Vector2(x + across * width, y + (1 - up) * height);
    }
}
