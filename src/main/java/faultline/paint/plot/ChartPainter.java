package faultline.paint.plot;

import faultline.geometry.Vec;
import faultline.paint.plot.TextStyle.Anchor;
import java.util.List;

/** Draws a chart: grid, data, frame, axes, and the legend above the data, where it covers none. */
public final class ChartPainter {

    private static final double TITLE = 13;
    private static final double LABEL = 12;
    private static final double TICK = 11;
    private static final double LEFT = 62;
    private static final double RIGHT = 16;
    private static final double BOTTOM = 46;

    private final Drawing drawing;
    private final Chart chart;
    private final Theme theme;
    private final Area area;
    private final Area plot;
    private final Legend legend;

    private ChartPainter(Drawing drawing, Chart chart, Area area, Theme theme) {
        this.drawing = drawing;
        this.chart = chart;
        this.theme = theme;
        this.area = area;
        this.legend = new Legend(chart.marks(), theme, area.width() - LEFT - RIGHT);
        this.plot = area.inset(LEFT, 26 + legend.height(), RIGHT, BOTTOM);
    }

    /**
     * Draws a chart.
     *
     * @param drawing where to
     * @param chart what
     * @param area that it fills with its title and its axes' names
     * @param theme its colours
     */
    public static void paint(Drawing drawing, Chart chart, Area area, Theme theme) {
        new ChartPainter(drawing, chart, area, theme).paint();
    }

    private void paint() {
        text(chart.title(), new Vec(plot.x(), area.y() + 17), TextStyle.plain(TITLE, theme.palette().text()).inBold());
        legend.paint(drawing, plot.x(), area.y() + 24);
        paintMaps();
        paintGrid();
        MarkPainter painter = new MarkPainter(drawing, chart, plot, theme);
        chart.marks().forEach(painter::paint);
        frame();
        paintTicks();
        paintLabels();
    }

    /** Maps fill the whole plot, so they lie beneath the grid. */
    private void paintMaps() {
        for (Mark mark : chart.marks()) {
            if (mark instanceof Mark.Cells cells) {
                new MarkPainter(drawing, chart, plot, theme).map(cells);
            }
        }
    }

    private void paintGrid() {
        Pen pen = Pen.solid(theme.grid(), 1);
        chart.x().ticks().forEach(tick -> line(at(chart.x().share(tick), 0), at(chart.x().share(tick), 1), pen));
        chart.y().ticks().forEach(tick -> line(at(0, chart.y().share(tick)), at(1, chart.y().share(tick)), pen));
    }

    private void frame() {
        drawing.stroke(List.of(at(0, 0), at(1, 0), at(1, 1), at(0, 1)), true, Pen.solid(theme.palette().text(), 1));
    }

    private void paintTicks() {
        Pen pen = Pen.solid(theme.palette().text(), 1);
        TextStyle style = TextStyle.plain(TICK, theme.palette().text());
        for (double tick : chart.x().ticks()) {
            Vec foot = at(chart.x().share(tick), 0);
            line(foot, foot.plus(new Vec(0, 4)), pen);
            text(Axis.name(tick), foot.plus(new Vec(0, 17)), style.anchored(Anchor.MIDDLE));
        }
        for (double tick : chart.y().ticks()) {
            Vec foot = at(0, chart.y().share(tick));
            line(foot, foot.minus(new Vec(4, 0)), pen);
            text(Axis.name(tick), foot.plus(new Vec(-8, 4)), style.anchored(Anchor.END));
        }
    }

    private void paintLabels() {
        TextStyle style = TextStyle.plain(LABEL, theme.palette().text()).anchored(Anchor.MIDDLE);
        text(chart.x().label(), at(0.5, 0).plus(new Vec(0, 36)), style);
        text(chart.y().label(), new Vec(area.x() + 14, at(0, 0.5).y()), style.goingUp());
    }

    private Vec at(double across, double up) {
        return plot.at(across, up);
    }

    private void line(Vec from, Vec to, Pen pen) {
        drawing.stroke(List.of(from, to), false, pen);
    }

    private void text(String text, Vec at, TextStyle style) {
        drawing.text(text, at, style);
    }
}
