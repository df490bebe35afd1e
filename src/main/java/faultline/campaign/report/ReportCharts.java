package faultline.campaign.report;

import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.ChartPainter;
import faultline.paint.chart.Histogram;
import faultline.paint.chart.Series;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Palette;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.SvgSurface;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The charts of reports as elements of a page. */
final class ReportCharts {

    /** The style of all pictures; the page replaces its colours on dark screens. */
    static final ChartStyle STYLE = ChartStyle.LIGHT;

    private static final int WIDTH = 340;
    private static final int HEIGHT = 190;
    private static final int ROW_HEIGHT = 20;
    private static final int ROWS_WIDTH = 440;
    /** The height of a chart of rows without its rows. */
    private static final int AXIS_HEIGHT = 56;

    private static final int BAR_LENGTH = 60;
    private static final Vector2 BAR_START = new Vector2(2, 4);
    private static final int TRACK_ALPHA = 128;
    private static final Vector2 GAP = new Vector2(Double.NaN, Double.NaN);

    private ReportCharts() {}

    /** A value, and its interval at a position; all in the unit of their axes. */
    record Estimate(double position, double value, Interval interval) {}

    /** Returns a chart; the title is for screen readers. */
    static String chart(Chart chart, int width, int height, String title) {
        SvgSurface surface = new SvgSurface(width, height);
        ChartPainter.paint(surface, chart, new PixelRectangle(0, 0, width, height), STYLE);
        return surface.toHtml("chart", title);
    }

    /** Returns a chart with a row for each name, from above; empty without names. */
    static String rows(String title, Axis x, List<String> names, List<Series> series) {
        if (names.isEmpty()) {
            return "";
        }
        List<String> upwards =
                new ArrayList<>(names.stream().map(TextStyle::literal).toList());
        Collections.reverse(upwards);
        Chart chart = new Chart("", x, Axis.rows(upwards), series);
        int width = ROWS_WIDTH + (int) ChartPainter.leftMargin(upwards);
        return chart(chart, width, AXIS_HEIGHT + ROW_HEIGHT * names.size(), title);
    }

    /** Returns a histogram of some values, with their number below. */
    static String histogram(String title, double[] values) {
        String label = TextStyle.literal(title) + ", n " + values.length;
        return chart(Histogram.chart("", label, "runs", values), WIDTH, HEIGHT, title);
    }

    /** Returns a chart of shares, in per cent, over a variable. */
    static String shares(String title, String label, double low, double high, List<Estimate> shares) {
        List<Vector2> intervals = new ArrayList<>();
        List<Vector2> dots = new ArrayList<>();
        for (Estimate share : shares) {
            intervals.add(new Vector2(share.position(), 100 * share.interval().low()));
            intervals.add(new Vector2(share.position(), 100 * share.interval().high()));
            intervals.add(GAP);
            dots.add(new Vector2(share.position(), 100 * share.value()));
        }
        Chart chart = new Chart(
                "",
                Axis.linear(TextStyle.literal(label), low, high > low ? high : low + Math.max(1e-9, Math.abs(low))),
                Axis.linear("carried on (%)", 0, 100),
                List.of(new Series.Line("", intervals, 0), new Series.Points("", dots, 0)));
        return chart(chart, WIDTH, HEIGHT, title);
    }

    /** Returns rows of differences of shares with their intervals about 0, in percentage points. */
    static String differences(String title, List<String> names, List<Comparison.Difference> differences) {
        List<Vector2> intervals = new ArrayList<>();
        List<Vector2> dots = new ArrayList<>();
        double most = 0.1;
        for (int i = 0; i < differences.size(); i++) {
            Interval interval = differences.get(i).interval();
            int row = names.size() - 1 - i;
            intervals.add(new Vector2(100 * interval.low(), row));
            intervals.add(new Vector2(100 * interval.high(), row));
            intervals.add(GAP);
            dots.add(new Vector2(100 * differences.get(i).value(), row));
            most = Math.max(most, Math.max(Math.abs(interval.low()), Math.abs(interval.high())));
        }
        double end = 10 * Math.ceil(10 * most);
        return rows(
                title,
                Axis.linear(TextStyle.literal(title), -end, end),
                names,
                List.of(new Series.Line("", intervals, 0), new Series.Points("", dots, 0)));
    }

    /** Returns a bar from 0 to 1 that shows the interval of a share. */
    static String intervalBar(Survival survival) {
        SvgSurface surface = new SvgSurface(BAR_LENGTH + 4, 8);
        Palette palette = STYLE.palette();
        bar(surface, 0, 1, LineStyle.solid(Palette.withAlpha(palette.muted(), TRACK_ALPHA), 1.5));
        Interval interval = survival.interval();
        bar(surface, interval.low(), interval.high(), LineStyle.solid(palette.text(), 2));
        surface.fill(Shapes.circle(onBar(survival.share()), 2.4), palette.text());
        return surface.toHtml("bar", "");
    }

    private static void bar(SvgSurface surface, double from, double to, LineStyle style) {
        surface.draw(Shapes.polyline(List.of(onBar(from), onBar(to))), style);
    }

    private static Vector2 onBar(double share) {
        return BAR_START.plus(new Vector2(BAR_LENGTH * share, 0));
    }
}
