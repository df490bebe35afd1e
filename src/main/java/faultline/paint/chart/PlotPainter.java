package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Paints the parts that all charts share: grid lines, the labels of ticks, lines that are clipped at the plot, and
 * series.
 */
public record PlotPainter(Surface surface, Plot plot) {

    /** The largest rounding error of a value at the end of an axis, as a share of the axis. */
    private static final double ROUNDING = 1e-9;

    /** Paints a line at each tick of both axes. */
    public void paintGrid(LineStyle style) {
        plot.horizontal().ticks().forEach(tick -> {
            double share = plot.horizontal().fractionOf(tick);
            drawLine(plot.area().pointAt(share, 0), plot.area().pointAt(share, 1), style);
        });
        plot.vertical().ticks().forEach(tick -> {
            double share = plot.vertical().fractionOf(tick);
            drawLine(plot.area().pointAt(0, share), plot.area().pointAt(1, share), style);
        });
    }

    /** Paints the ticks of both axes with their values; values for which there is no room are omitted. */
    public void paintTicks(TickStyle style) {
        LineStyle mark = LineStyle.solid(style.text().colour(), 1);
        double widest = plot.horizontal().ticks().stream()
                .mapToDouble(tick -> style.text().estimateWidth(Axis.formatTick(tick) + style.unit()))
                .max()
                .orElse(0);
        int across = plot.horizontal().labelStride(plot.area().width(), widest);
        for (double tick : plot.horizontal().ticks()) {
            Vector2 foot = plot.area().pointAt(plot.horizontal().fractionOf(tick), 0);
            paintTick(foot, new Vector2(0, style.markLength()), mark);
            if (plot.horizontal().hasLabel(tick, across)) {
                surface.drawText(
                        Axis.formatTick(tick) + style.unit(),
                        foot.plus(new Vector2(0, style.below())),
                        style.text().withAnchor(Anchor.MIDDLE));
            }
        }
        int up = plot.vertical().labelStride(plot.area().height(), style.text().size());
        for (double tick : plot.vertical().ticks()) {
            Vector2 foot = plot.area().pointAt(0, plot.vertical().fractionOf(tick));
            paintTick(foot, new Vector2(-style.markLength(), 0), mark);
            if (plot.vertical().hasLabel(tick, up)) {
                surface.drawText(
                        plot.vertical().tickLabel(tick),
                        foot.plus(new Vector2(-style.left(), 4)),
                        style.text().withAnchor(Anchor.END));
            }
        }
    }

    private void paintTick(Vector2 foot, Vector2 mark, LineStyle style) {
        if (mark.length() > 0) {
            drawLine(foot, foot.plus(mark), style);
        }
    }

    /** Paints a line through pairs of values as far as it lies in the plot; a pair that is not finite is a gap. */
    public void paintLine(List<Vector2> values, LineStyle style) {
        LineClipper.clip(values.stream().map(plot::toFractions).toList())
                .forEach(piece -> surface.draw(Shapes.polyline(toPicture(piece)), style));
    }

    /** Fills the band between two lines, both in the order of x. */
    public void paintBand(List<Vector2> upper, List<Vector2> lower, Color colour) {
        List<Vector2> outline = new ArrayList<>(lower);
        Collections.reverse(outline);
        outline.addAll(0, upper);
        List<Vector2> clamped =
                outline.stream().map(plot::toFractions).map(PlotPainter::clamp).toList();
        surface.fill(Shapes.polygon(toPicture(clamped)), colour);
    }

    /** Returns the corners of a rectangle whose sides are at fractions of an area. */
    static List<Vector2> corners(PixelRectangle area, double left, double low, double right, double high) {
        return List.of(
                area.pointAt(left, low), area.pointAt(right, low), area.pointAt(right, high), area.pointAt(left, high));
    }

    private void drawLine(Vector2 from, Vector2 to, LineStyle style) {
        surface.draw(Shapes.polyline(List.of(from, to)), style);
    }

    /** Paints a marker at each of some values that is inside the plot. */
    void paintMarkers(List<Vector2> values, int styleIndex, ChartStyle style) {
        values.stream()
                .map(plot::toFractions)
                .filter(PlotPainter::isInside)
                .forEach(at -> MarkerPainter.paint(surface, toPicture(at), styleIndex, style));
    }

    private List<Vector2> toPicture(List<Vector2> fractions) {
        return fractions.stream().map(this::toPicture).toList();
    }

    private Vector2 toPicture(Vector2 fractions) {
        return plot.area().pointAt(fractions.x(), fractions.y());
    }

    private static boolean isInside(Vector2 fractions) {
        return fractions.distanceTo(clamp(fractions)) < ROUNDING;
    }

    private static Vector2 clamp(Vector2 fractions) {
        return new Vector2(Math.max(0, Math.min(1, fractions.x())), Math.max(0, Math.min(1, fractions.y())));
    }
}
