package faultline.studies;

import faultline.geometry.Vector2;
import faultline.paint.chart.Chart;
import faultline.paint.chart.ChartPainter;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.SvgDrawing;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** One picture on paper: the drawing, and the sizes and pens that all figures share. */
final class FigureCanvas {

    static final ChartStyle THEME = ChartStyle.LIGHT;
    static final Color FOREGROUND = THEME.palette().text();
    static final TextStyle TEXT_STYLE = TextStyle.plain(12, FOREGROUND);
    static final TextStyle SMALL_TEXT = TextStyle.plain(11, FOREGROUND);
    static final LineStyle THIN_LINE = LineStyle.solid(FOREGROUND, 1);
    static final LineStyle PATH_LINE = LineStyle.solid(THEME.series().get(0), 1.8);

    private final SvgDrawing drawing;

    FigureCanvas(int width, int height) {
        drawing = new SvgDrawing(width, height, THEME.palette().canvas());
    }

    SvgDrawing drawing() {
        return drawing;
    }

    /** A part of the world in an area. */
    PlanView addPlan(PixelRectangle area, Rectangle2D bounds) {
        return new PlanView(drawing, area, bounds, THEME);
    }

    void addChart(Chart chart, PixelRectangle area) {
        ChartPainter.paint(drawing, chart, area, THEME);
    }

    void addText(String text, double x, double y, TextStyle style) {
        drawing.drawText(text, new Vector2(x, y), style);
    }

    /** Lines of text, one below the other, about a middle. */
    void addLines(List<String> lines, double middle, double y) {
        for (int i = 0; i < lines.size(); i++) {
            addText(lines.get(i), middle, y + 15 * i, SMALL_TEXT.withAnchor(Anchor.MIDDLE));
        }
    }

    /** A chart on a sheet of its own. */
    static SvgDrawing drawChart(Chart chart, int width, int height) {
        FigureCanvas sheet = new FigureCanvas(width, height);
        sheet.addChart(chart, new PixelRectangle(0, 4, width, height - 8));
        return sheet.drawing;
    }
}
