package faultline.app.figures;

import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Chart;
import faultline.paint.plot.ChartPainter;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.paint.plot.SvgDrawing;
import faultline.paint.plot.TextStyle;
import faultline.paint.plot.TextStyle.Anchor;
import faultline.paint.plot.Theme;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** One picture on paper: the drawing, and the sizes and pens that all figures share. */
final class Sheet {

    static final Theme THEME = Theme.LIGHT;
    static final Color INK = THEME.palette().text();
    static final TextStyle TEXT = TextStyle.plain(12, INK);
    static final TextStyle SMALL = TextStyle.plain(11, INK);
    static final Pen THIN = Pen.solid(INK, 1);
    static final Pen PATH = Pen.solid(THEME.series().get(0), 1.8);

    private final SvgDrawing drawing;

    Sheet(int width, int height) {
        drawing = new SvgDrawing(width, height, THEME.palette().canvas());
    }

    SvgDrawing drawing() {
        return drawing;
    }

    /** A part of the world in an area. */
    Plan plan(Area area, Rectangle2D bounds) {
        return new Plan(drawing, area, bounds, THEME);
    }

    void chart(Chart chart, Area area) {
        ChartPainter.paint(drawing, chart, area, THEME);
    }

    void text(String text, double x, double y, TextStyle style) {
        drawing.text(text, new Vec(x, y), style);
    }

    /** Lines of text, one below the other, about a middle. */
    void lines(List<String> lines, double middle, double y) {
        for (int i = 0; i < lines.size(); i++) {
            text(lines.get(i), middle, y + 15 * i, SMALL.anchored(Anchor.MIDDLE));
        }
    }

    /** A chart on a sheet of its own. */
    static SvgDrawing of(Chart chart, int width, int height) {
        Sheet sheet = new Sheet(width, height);
        sheet.chart(chart, new Area(0, 4, width, height - 8));
        return sheet.drawing;
    }
}
