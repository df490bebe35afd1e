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

/** A picture for a figure with its caption below, in the sizes and styles that all figures share. */
public final class FigureCanvas {

    public static final ChartStyle THEME = ChartStyle.LIGHT;
    public static final Color FOREGROUND = THEME.palette().text();
    public static final TextStyle TEXT_STYLE = TextStyle.plain(12, FOREGROUND);
    public static final TextStyle SMALL_TEXT = TextStyle.plain(11, FOREGROUND);
    public static final LineStyle PATH_LINE = LineStyle.solid(THEME.series().get(0), 1.8);

    private static final int CAPTION_MARGIN = 14;
    private static final int LINE_HEIGHT = 15;

    private final SvgSurface surface;

    /**
     * Creates a picture of a size in pixels, below which a caption is added. The caption explains the figure without
     * the text around it: what is shown, the unit, the number of runs, and the meaning of the marks.
     */
    public FigureCanvas(int width, int height, String caption) {
        List<String> lines = SMALL_TEXT.wrap(caption, width - 2 * CAPTION_MARGIN);
        surface = new SvgSurface(
                width,
                height + CAPTION_MARGIN + LINE_HEIGHT * lines.size(),
                THEME.palette().canvas());
        for (int i = 0; i < lines.size(); i++) {
            addText(lines.get(i), CAPTION_MARGIN, height + LINE_HEIGHT * (i + 1), SMALL_TEXT);
        }
    }

    public SvgSurface surface() {
        return surface;
    }

    /** Adds a view of a part of the world in an area of the picture. */
    public PlanView addPlan(PixelRectangle area, Rectangle2D bounds) {
        return new PlanView(surface, area, bounds, THEME);
    }

    public void addChart(Chart chart, PixelRectangle area) {
        ChartPainter.paint(surface, chart, area, THEME);
    }

    public void addText(String text, double x, double y, TextStyle style) {
        surface.drawText(text, new Vector2(x, y), style);
    }

    /** Adds lines of text, one below the other, centred horizontally on a position. */
    public void addLines(List<String> lines, double middle, double y) {
        for (int i = 0; i < lines.size(); i++) {
            addText(lines.get(i), middle, y + LINE_HEIGHT * i, SMALL_TEXT.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Adds the letter and the title of a panel, whose index counts from 0, centred horizontally on a position. */
    public void addPanelTitle(int index, String title, double middle, double y) {
        addText(panelTitle(index, title), middle, y, TEXT_STYLE.withBold().withAnchor(Anchor.MIDDLE));
    }

    /** Returns the title of a panel after its letter, such as {@code (a)} for index 0. */
    public static String panelTitle(int index, String title) {
        return "(" + (char) ('a' + index) + ") " + title;
    }
}
