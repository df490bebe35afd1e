package faultline.campaign.report;

import java.util.List;

/** Small charts as inline SVG, coloured by the style sheet of the page. */
final class Svg {

    private static final int WIDTH = 340;
    private static final int HEIGHT = 190;
    private static final int LEFT = 52;
    private static final int RIGHT = 16;
    private static final int TOP = 10;
    private static final int BOTTOM = 38;

    private Svg() {}

    /** A place in a chart: a value with its interval over a position. */
    record ShareMark(double x, double y, Interval interval) {}

    /** Returns a bar that shows the interval of a share on the way from 0 to 1. */
    static String intervalBar(Survival survival) {
        double low = 60 * survival.interval().low();
        double high = 60 * survival.interval().high();
        return Html.format(
                "<svg class=\"bar\" viewBox=\"-2 0 64 8\" width=\"64\" height=\"8\" aria-hidden=\"true\">"
                        + "<path class=\"track\" d=\"M0 4H60\"/><path class=\"range\" d=\"M%.1f 4H%.1f\"/>"
                        + "<circle class=\"dot\" cx=\"%.1f\" cy=\"4\" r=\"2.4\"/></svg>",
                low, high, 60 * survival.share());
    }

    /** Returns a histogram of some values, with their number below. */
    static String histogram(String title, double[] values, int bins) {
        double low = java.util.Arrays.stream(values).min().orElse(0);
        double high = java.util.Arrays.stream(values).max().orElse(1);
        Axes nice = Axes.nice(low, high, 0, 1);
        double width = (nice.xHigh - nice.xLow) / bins;
        int[] counts = new int[bins];
        for (double value : values) {
            counts[(int) Math.min(bins - 1, (value - nice.xLow) / width)]++;
        }
        int most = java.util.Arrays.stream(counts).max().orElse(1);
        Axes axes = Axes.nice(nice.xLow, nice.xHigh, 0, most);
        StringBuilder out = axes.open(title, title + ", n " + values.length, "runs");
        for (int i = 0; i < bins; i++) {
            double left = axes.x(nice.xLow + i * width);
            double right = axes.x(nice.xLow + (i + 1) * width);
            double top = axes.y(counts[i]);
            out.append(Html.format(
                    "<rect class=\"fill\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>",
                    left + 0.5, top, Math.max(0.5, right - left - 1), HEIGHT - BOTTOM - top));
        }
        return out.append("</svg>\n").toString();
    }

    /** Returns a chart of shares over a variable. */
    static String shares(String title, String label, double low, double high, List<ShareMark> points) {
        Axes axes = Axes.nice(low, high, 0, 100);
        StringBuilder out = axes.open(title, label, "carried on (%)");
        for (ShareMark point : points) {
            double x = axes.x(point.x);
            double bottom = axes.y(100 * point.interval.low());
            double top = axes.y(100 * point.interval.high());
            out.append(path("range", Html.format("M%.1f %.1fV%.1f", x, bottom, top)));
            out.append(dot(x, axes.y(100 * point.y), 3));
        }
        return out.append("</svg>\n").toString();
    }

    /** Returns the start tag of a chart with its title. */
    static String open(int width, int height, String title) {
        return Html.format("<svg class=\"chart\" viewBox=\"0 0 %d %d\" width=\"%d\" ", width, height, width)
                + Html.format("height=\"%d\" role=\"img\"><title>%s</title>", height, Html.escape(title));
    }

    static String path(String css, String data) {
        return "<path class=\"" + css + "\" d=\"" + data + "\"/>";
    }

    static String dot(double x, double y, double radius) {
        return Html.format("<circle class=\"dot\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>", x, y, radius);
    }

    static String text(String css, String anchor, double x, double y, String text) {
        return Html.format("<text class=\"%s\" text-anchor=\"%s\" x=\"%.1f\" y=\"%.1f\">", css, anchor, x, y)
                + Html.escape(text) + "</text>";
    }

    /** The two axes of a chart, with ticks at round numbers. */
    private record Axes(double xLow, double xHigh, double xStep, double yHigh, double yStep) {

        /** Returns axes that hold some ranges, up to the next ticks; y begins at 0. */
        static Axes nice(double xLow, double xHigh, double yLow, double yHigh) {
            double span = xHigh > xLow ? xHigh - xLow : Math.max(1e-9, Math.abs(xLow));
            double xStep = step(span);
            double yStep = step(yHigh - yLow);
            return new Axes(
                    Math.floor(xLow / xStep + 1e-9) * xStep,
                    Math.ceil((xLow + span) / xStep - 1e-9) * xStep,
                    xStep,
                    Math.ceil(yHigh / yStep - 1e-9) * yStep,
                    yStep);
        }

        /** Returns the round number that divides a span into three to six parts. */
        private static double step(double span) {
            double power = Math.pow(10, Math.floor(Math.log10(span / 4)));
            double parts = span / 4 / power;
            return power * (parts < 1.5 ? 1 : parts < 3.5 ? 2 : parts < 7.5 ? 5 : 10);
        }

        double x(double value) {
            return LEFT + (value - xLow) / (xHigh - xLow) * (WIDTH - LEFT - RIGHT);
        }

        double y(double value) {
            return HEIGHT - BOTTOM - value / yHigh * (HEIGHT - TOP - BOTTOM);
        }

        StringBuilder open(String title, String xLabel, String yLabel) {
            StringBuilder out = new StringBuilder(Svg.open(WIDTH, HEIGHT, title));
            for (int i = 0; i <= Math.round(yHigh / yStep); i++) {
                double y = y(i * yStep);
                out.append(path("grid", Html.format("M%d %.1fH%d", LEFT, y, WIDTH - RIGHT)));
                out.append(text("tick", "end", LEFT - 5, y + 4, tick(i * yStep)));
            }
            for (int i = 0; i <= Math.round((xHigh - xLow) / xStep); i++) {
                double value = xLow + i * xStep;
                out.append(text("tick", "middle", x(value), HEIGHT - BOTTOM + 15, tick(value)));
            }
            out.append(path("axis", Html.format("M%d %dH%d", LEFT, HEIGHT - BOTTOM, WIDTH - RIGHT)));
            out.append(text("label", "middle", (LEFT + WIDTH - RIGHT) / 2.0, HEIGHT - 6, xLabel));
            return out.append(
                            Html.format("<g transform=\"translate(11 %d) rotate(-90)\">", (TOP + HEIGHT - BOTTOM) / 2))
                    .append(text("label", "middle", 0, 0, yLabel))
                    .append("</g>");
        }

        private static String tick(double value) {
            return faultline.io.DecimalText.formatRounded(Math.abs(value) < 1e-12 ? 0 : value);
        }
    }
}
