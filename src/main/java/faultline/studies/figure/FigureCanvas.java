package faultline.studies.figure;

import faultline.geometry.Vector2;
import faultline.paint.chart.Chart;
import faultline.paint.chart.ChartPainter;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.SvgSurface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** A picture for a figure, with the sizes and styles that all figures share. */
public final class FigureCanvas {

    public static final ChartStyle THEME = ChartStyle.LIGHT;
    public static final Color FOREGROUND = THEME.palette().text();
    public static final TextStyle TEXT_STYLE = TextStyle.plain(12, FOREGROUND);
    public static final TextStyle SMALL_TEXT = TextStyle.plain(11, FOREGROUND);
    public static final LineStyle THIN_LINE = LineStyle.solid(FOREGROUND, 1);
    public static final LineStyle PATH_LINE = LineStyle.solid(THEME.series().get(0), 1.8);

    private final SvgSurface surface;

    public FigureCanvas(int width, int height) {
        surface = new SvgSurface(width, height, THEME.palette().canvas());
    }

    public SvgSurface surface() {
        return surface;
    }

    /** Adds a view of a part of the world in an area. */
    public PlanView addPlan(PixelRectangle area, Rectangle2D bounds) {
        return new PlanView(surface, area, bounds, THEME);
    }

    public void addChart(Chart chart, PixelRectangle area) {
        ChartPainter.paint(surface, chart, area, THEME);
    }

    public void addText(String text, double x, double y, TextStyle style) {
        surface.drawText(text, new Vector2(x, y), style);
    }

    /** Adds lines of text, one below the other, centred on a middle. */
    public void addLines(List<String> lines, double middle, double y) {
        for (int i = 0; i < lines.size(); i++) {
            addText(lines.get(i), middle, y + 15 * i, SMALL_TEXT.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Draws a chart on a picture of its own. */
    public static SvgSurface drawChart(Chart chart, int width, int height) {
        FigureCanvas canvas = new FigureCanvas(width, height);
        canvas.addChart(chart, new PixelRectangle(0, 4, width, height - 8));
        return canvas.surface;
    }
}
