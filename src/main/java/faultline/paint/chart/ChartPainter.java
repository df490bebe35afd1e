package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Drawing;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.util.List;

/** Draws a chart: grid, data, frame, axes, and the legend above the data, where it covers none. */
public final class ChartPainter {

    private static final double TITLE_SIZE = 13;
    private static final double LABEL_SIZE = 12;
    private static final double TICK_SIZE = 11;
    private static final double LEFT_MARGIN = 62;
    private static final double RIGHT_MARGIN = 16;
    private static final double BOTTOM_MARGIN = 46;

    private final Drawing drawing;
    private final Chart chart;
    private final ChartStyle theme;
    private final PixelRectangle area;
    private final PixelRectangle plotArea;
    private final Legend legend;

    private ChartPainter(Drawing drawing, Chart chart, PixelRectangle area, ChartStyle theme) {
        this.drawing = drawing;
        this.chart = chart;
        this.theme = theme;
        this.area = area;
        this.legend = new Legend(chart.series(), theme, area.width() - LEFT_MARGIN - RIGHT_MARGIN);
        this.plotArea = area.inset(LEFT_MARGIN, 26 + legend.height(), RIGHT_MARGIN, BOTTOM_MARGIN);
    }

    /**
     * Draws a chart.
     *
     * @param drawing where to
     * @param chart what
     * @param area that it fills with its title and its axes' names
     * @param theme its colours
     */
    public static void paint(Drawing drawing, Chart chart, PixelRectangle area, ChartStyle theme) {
        new ChartPainter(drawing, chart, area, theme).paint();
    }

    private void paint() {
        drawText(
                chart.title(),
                new Vector2(plotArea.x(), area.y() + 17),
                TextStyle.plain(TITLE_SIZE, theme.palette().text()).withBold());
        legend.paint(drawing, plotArea.x(), area.y() + 24);
        paintCells();
        paintGrid();
        SeriesPainter painter = new SeriesPainter(drawing, chart, plotArea, theme);
        chart.series().forEach(painter::paint);
        paintFrame();
        paintTicks();
        paintLabels();
    }

    /** Maps fill the whole plot, so they lie beneath the grid. */
    private void paintCells() {
        for (Series mark : chart.series()) {
            if (mark instanceof Series.Cells cells) {
                new SeriesPainter(drawing, chart, plotArea, theme).paintCells(cells);
            }
        }
    }

    private void paintGrid() {
        LineStyle pen = LineStyle.solid(theme.grid(), 1);
        chart.x()
                .ticks()
                .forEach(tick -> drawLine(
                        pointAt(chart.x().fractionOf(tick), 0),
                        pointAt(chart.x().fractionOf(tick), 1),
                        pen));
        chart.y()
                .ticks()
                .forEach(tick -> drawLine(
                        pointAt(0, chart.y().fractionOf(tick)),
                        pointAt(1, chart.y().fractionOf(tick)),
                        pen));
    }

    private void paintFrame() {
        drawing.drawPolyline(
                List.of(pointAt(0, 0), pointAt(1, 0), pointAt(1, 1), pointAt(0, 1)),
                true,
                LineStyle.solid(theme.palette().text(), 1));
    }

    private void paintTicks() {
        LineStyle pen = LineStyle.solid(theme.palette().text(), 1);
        TextStyle style = TextStyle.plain(TICK_SIZE, theme.palette().text());
        for (double tick : chart.x().ticks()) {
            Vector2 foot = pointAt(chart.x().fractionOf(tick), 0);
            drawLine(foot, foot.plus(new Vector2(0, 4)), pen);
            drawText(Axis.formatTick(tick), foot.plus(new Vector2(0, 17)), style.withAnchor(Anchor.MIDDLE));
        }
        for (double tick : chart.y().ticks()) {
            Vector2 foot = pointAt(0, chart.y().fractionOf(tick));
            drawLine(foot, foot.minus(new Vector2(4, 0)), pen);
            drawText(Axis.formatTick(tick), foot.plus(new Vector2(-8, 4)), style.withAnchor(Anchor.END));
        }
    }

    private void paintLabels() {
        TextStyle style = TextStyle.plain(LABEL_SIZE, theme.palette().text()).withAnchor(Anchor.MIDDLE);
        drawText(chart.x().label(), pointAt(0.5, 0).plus(new Vector2(0, 36)), style);
        drawText(chart.y().label(), new Vector2(area.x() + 14, pointAt(0, 0.5).y()), style.rotated());
    }

    private Vector2 pointAt(double across, double up) {
        return plotArea.pointAt(across, up);
    }

    private void drawLine(Vector2 from, Vector2 to, LineStyle pen) {
        drawing.drawPolyline(List.of(from, to), false, pen);
    }

    private void drawText(String text, Vector2 at, TextStyle style) {
        drawing.drawText(text, at, style);
    }
}
