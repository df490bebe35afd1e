package faultline.campaign.report;

import java.util.List;

/** Rows of differences with their intervals about a line at 0, in percentage points. */
final class ForestChart {

    private static final int ROW = 20;
    private static final int TOP = 10;
    private static final int PLOT_WIDTH = 430;

    /** About the width of a letter of a name. */
    private static final double LETTER = 6.6;

    private final String title;
    private final List<String> names;
    private final List<Comparison.Difference> differences;
    private final double most;
    private final int bottom;
    private final int left;
    private final int width;
    private final double middle;

    /**
     * Creates a chart.
     *
     * @param title what is subtracted from what
     * @param names of the rows
     * @param differences of the rows, of shares
     */
    ForestChart(String title, List<String> names, List<Comparison.Difference> differences) {
        this.title = title;
        this.names = names;
        this.differences = differences;
        this.most = extent(differences);
        this.bottom = TOP + names.size() * ROW;
        this.left = 20
                + (int) (LETTER * names.stream().mapToInt(String::length).max().orElse(0));
        this.width = left + PLOT_WIDTH;
        this.middle = left + (PLOT_WIDTH - 20) / 2.0;
    }

    /** Returns the end of the axis: the next full ten percentage points. */
    private static double extent(List<Comparison.Difference> differences) {
        double most = 0;
        for (Comparison.Difference difference : differences) {
            Interval interval = difference.interval();
            most = Math.max(most, Math.max(Math.abs(interval.low()), Math.abs(interval.high())));
        }
        return Math.min(1, Math.max(0.1, Math.ceil(most * 10) / 10));
    }

    private double x(double difference) {
        return middle + Math.max(-most, Math.min(most, difference)) * (width - middle - 20) / most;
    }

    /** Returns the chart. */
    String svg() {
        StringBuilder out = new StringBuilder(Svg.open(width, bottom + 34, title));
        for (double part : new double[] {-1, -0.5, 0, 0.5, 1}) {
            double x = x(part * most);
            String label = part == 0 ? "0" : Html.format("%+.0f", 100 * part * most);
            out.append(Svg.path(part == 0 ? "axis" : "grid", Html.format("M%.1f %dV%d", x, TOP, bottom)));
            out.append(Svg.text("tick", "middle", x, bottom + 14, label));
        }
        for (int i = 0; i < names.size(); i++) {
            Interval interval = differences.get(i).interval();
            double y = TOP + (i + 0.5) * ROW;
            out.append(Svg.text("row", "end", left - 8, y + 4, names.get(i)));
            out.append(Svg.path("range", Html.format("M%.1f %.1fH%.1f", x(interval.low()), y, x(interval.high()))));
            out.append(Svg.dot(x(differences.get(i).value()), y, 3.5));
        }
        return out.append(Svg.text("label", "middle", middle, bottom + 30, title))
                .append("</svg>\n")
                .toString();
    }
}
