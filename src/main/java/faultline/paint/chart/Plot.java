package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.PixelRectangle;

/** The rectangle of a chart in which its data lie, and its axes: the one place where values become pixels. */
public record Plot(PixelRectangle area, Axis horizontal, Axis vertical) {

    /** Returns the x coordinate of a value on the horizontal axis, pixels. */
    public double x(double value) {
        return area.x() + horizontal.fractionOf(value) * area.width();
    }

    /** Returns the y coordinate of a value on the vertical axis, pixels. */
    public double y(double value) {
        return area.y() + (1 - vertical.fractionOf(value)) * area.height();
    }

    /** Returns the position of a pair of values, pixels. */
    public Vector2 toPicture(Vector2 values) {
        return area.pointAt(horizontal.fractionOf(values.x()), vertical.fractionOf(values.y()));
    }

    /** Returns a pair of values as fractions of the axes. */
    Vector2 toFractions(Vector2 values) {
        return new Vector2(horizontal.fractionOf(values.x()), vertical.fractionOf(values.y()));
    }
}
