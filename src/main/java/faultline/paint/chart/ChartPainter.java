package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;

/** Paints a whole chart for a figure: title, legend above the data, map, grid, series, frame and axes. */
public final class ChartPainter {

    private static final double TITLE_SIZE = 13;
    private static final double LABEL_SIZE = 12;
    private static final double TICK_SIZE = 11;
    private static final double LEFT_MARGIN = 62;
    private static final double RIGHT_MARGIN = 16;
    private static final double BOTTOM_MARGIN = 46;

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
        this.legend = new Legend(chart.series(), style, area.width() - LEFT_MARGIN - RIGHT_MARGIN);
        this.plotArea = area.inset(LEFT_MARGIN, 26 + legend.height(), RIGHT_MARGIN, BOTTOM_MARGIN);
        this.painter = new PlotPainter(surface, new Plot(plotArea, chart.x(), chart.y()));
    }

    /**
     * Paints a chart.
     *
     * @param surface the target
     * @param chart what to paint
     * @param area filled by the chart, its title and the labels of its axes
     * @param style its colours
     */
    public static void paint(Surface surface, Chart chart, PixelRectangle area, ChartStyle style) {
        new ChartPainter(surface, chart, area, style).paint();
    }

    private void paint() {
        surface.drawText(
                chart.title(),
                new Vector2(plotArea.x(), area.y() + 17),
                TextStyle.plain(TITLE_SIZE, style.palette().text()).withBold());
        legend.paint(surface, plotArea.x(), area.y() + 24);
        paintCells();
        painter.paintGrid(LineStyle.solid(style.grid(), 1));
        chart.series().forEach(series -> painter.paint(series, style));
        surface.draw(
                Shapes.polygon(PlotPainter.corners(plotArea, 0, 0, 1, 1)),
                LineStyle.solid(style.palette().text(), 1));
        painter.paintTicks(
                new TickStyle(TextStyle.plain(TICK_SIZE, style.palette().text()), 4, 8, 17, ""));
        paintLabels();
    }

    /** Maps fill the whole plot, so they lie beneath the grid. */
    private void paintCells() {
        for (Series series : chart.series()) {
            if (series instanceof Series.Cells cells) {
                painter.paintCells(cells, style);
            }
        }
    }

    private void paintLabels() {
        TextStyle label = TextStyle.plain(LABEL_SIZE, style.palette().text()).withAnchor(Anchor.MIDDLE);
        surface.drawText(chart.x().label(), plotArea.pointAt(0.5, 0).plus(new Vector2(0, 36)), label);
        surface.drawText(
                chart.y().label(),
                new Vector2(area.x() + 14, plotArea.pointAt(0, 0.5).y()),
                label.rotated());
    }
}
