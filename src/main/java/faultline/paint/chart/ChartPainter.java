package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.util.List;
import java.util.function.Predicate;

/** Paints a whole chart for a figure: title, legend above the data, map, grid, series, frame and axes. */
public final class ChartPainter {

    private static final double TITLE_SIZE = 13;
    private static final double LABEL_SIZE = 12;
    private static final double LEFT_MARGIN = 62;
    private static final double MIN_RIGHT_MARGIN = 16;
    private static final double BOTTOM_MARGIN = 46;
    private static final double TITLE_HEIGHT = 26;
    /** Above the plot of a chart without a title, for half a label of the vertical axis. */
    private static final double TOP_MARGIN = 10;

    private static final double MARK_LENGTH = 4;
    private static final double LABEL_DISTANCE = 8;

    /** The series that fill the whole plot and lie beneath the grid. */
    private static final Predicate<Series> MAPS = Series.Cells.class::isInstance;

    private final Surface surface;
    private final Chart chart;
    private final ChartStyle style;
    private final PixelRectangle area;
    private final PixelRectangle plotArea;
    private final PlotPainter painter;
    private final Legend legend;

    private ChartPainter(Surface surface, Chart chart, PixelRectangle area, ChartStyle style) {
        this.surface = surface;
        this.chart = chart;
        this.style = style;
        this.area = area;
        double left =
                chart.y().rows().isEmpty() ? LEFT_MARGIN : leftMargin(chart.y().rows());
        double top = chart.title().isEmpty() ? TOP_MARGIN : TITLE_HEIGHT;
        double right = rightMargin(chart.x(), area.width() - left);
        this.legend = new Legend(chart.series(), style, area.width() - left - right);
        this.plotArea = area.inset(left, top + legend.height(), right, BOTTOM_MARGIN);
        this.painter = new PlotPainter(surface, new Plot(plotArea, chart.x(), chart.y()));
    }

    /** Paints a chart with its title and the labels of its axes into an area. */
    public static void paint(Surface surface, Chart chart, PixelRectangle area, ChartStyle style) {
        new ChartPainter(surface, chart, area, style).paint();
    }

    /** Returns the width that the names of rows need beside the plot, pixels. */
    public static double leftMargin(List<String> rows) {
        TextStyle text = TextStyle.plain(ChartStyle.TEXT_SIZE, Color.BLACK);
        return 2 * LABEL_DISTANCE
                + rows.stream().mapToDouble(text::estimateWidth).max().orElse(0);
    }

    /** Returns the width beside the plot, pixels, for the half of the last label that may be there. */
    private static double rightMargin(Axis axis, double width) {
        List<Double> ticks = axis.ticks();
        double last = ticks.get(ticks.size() - 1);
        double half = TextStyle.plain(ChartStyle.TEXT_SIZE, Color.BLACK).estimateWidth(Axis.formatTick(last)) / 2;
        double beforeEnd = (1 - axis.fractionOf(last)) * (width - MIN_RIGHT_MARGIN);
        return Math.max(MIN_RIGHT_MARGIN, half - beforeEnd);
    }

    private void paint() {
        if (!chart.title().isEmpty()) {
            surface.drawText(
                    chart.title(),
                    new Vector2(plotArea.x(), area.y() + 17),
                    TextStyle.plain(TITLE_SIZE, style.palette().text()).withBold());
        }
        legend.paint(surface, plotArea.x(), plotArea.y() - legend.height() - 2);
        paintSeries(MAPS);
        painter.paintGrid(LineStyle.solid(style.grid(), 1));
        if (!chart.y().rows().isEmpty()) {
            List<Vector2> zero = List.of(
                    new Vector2(0, chart.y().low()), new Vector2(0, chart.y().high()));
            painter.paintLine(zero, LineStyle.solid(style.palette().muted(), 1));
        }
        paintSeries(MAPS.negate());
        surface.draw(
                Shapes.polygon(PlotPainter.corners(plotArea, 0, 0, 1, 1)),
                LineStyle.solid(style.palette().text(), 1));
        painter.paintTicks(new TickStyle(
                TextStyle.plain(ChartStyle.TEXT_SIZE, style.palette().text()), MARK_LENGTH, LABEL_DISTANCE, 17, ""));
        paintLabels();
    }

    private void paintSeries(Predicate<Series> chosen) {
        SeriesPainter seriesPainter = new SeriesPainter(painter, style);
        chart.series().stream().filter(chosen).forEach(seriesPainter::paint);
    }

    private void paintLabels() {
        TextStyle label = TextStyle.plain(LABEL_SIZE, style.palette().text()).withAnchor(Anchor.MIDDLE);
        surface.drawText(chart.x().label(), plotArea.pointAt(0.5, 0).plus(new Vector2(0, 36)), label);
        if (!chart.y().label().isEmpty()) {
            surface.drawText(
                    chart.y().label(),
                    new Vector2(area.x() + 14, plotArea.pointAt(0, 0.5).y()),
                    label.rotated());
        }
    }
}
