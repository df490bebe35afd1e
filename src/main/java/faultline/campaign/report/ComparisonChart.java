package faultline.campaign.report;

import faultline.engine.RobotPath;
import faultline.paint.scene.ObstacleOutlines;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.util.Arrays;
import java.util.List;

/** The charts of a comparison as inline SVG. Each controller has a colour and a dash pattern. */
final class ComparisonChart {

    /** The colours of Okabe and Ito without yellow and black, which colour-blind readers tell apart. */
    private static final List<String> COLOURS =
            List.of("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9");

    private static final List<String> DASHES = List.of("", "7 3", "2 3", "9 3 2 3", "4 2", "1 2");
    private static final double WIDTH = 900;
    private static final int SPREAD_WIDTH = 340;
    private static final int ROW = 26;
    private static final int MARGIN = 16;

    private ComparisonChart() {}

    private static String colour(int controller) {
        return COLOURS.get(controller % COLOURS.size());
    }

    private static String stroke(int controller, double width) {
        return Html.format(
                "fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" stroke-dasharray=\"%s\" stroke-linejoin=\"round\"",
                colour(controller), width, DASHES.get(controller / COLOURS.size() % DASHES.size()));
    }

    /** Returns the world with the paths of all runs over each other. */
    static String paths(WorldSpec world, List<ControllerRuns> controllers) {
        double scale = WIDTH / world.width();
        int height = (int) Math.ceil(world.height() * scale);
        StringBuilder out = new StringBuilder(Svg.open((int) WIDTH, height, "Paths of the controllers"));
        out.append(Html.format("<g transform=\"translate(0 %d) scale(1 -1)\">", height));
        out.append(Html.format(
                "<rect x=\"0\" y=\"0\" width=\"%.1f\" height=\"%d\" fill=\"none\" class=\"axis\"/>", WIDTH, height));
        for (Obstacle obstacle : world.obstacles()) {
            out.append("<path fill-rule=\"evenodd\" fill=\"var(--line)\" stroke=\"var(--muted)\" d=\"")
                    .append(outline(ObstacleOutlines.worldShape(obstacle), scale))
                    .append("\"/>\n");
        }
        for (int i = 0; i < controllers.size(); i++) {
            List<ControllerRuns.Run> runs = controllers.get(i).runs();
            for (int j = runs.size() - 1; j >= 0; j--) {
                out.append("<path ")
                        .append(stroke(i, j == 0 ? 2.4 : 0.8))
                        .append(" d=\"")
                        .append(line(runs.get(j).path(), scale))
                        .append("\"/>\n");
            }
        }
        return out.append("</g></svg>\n").toString();
    }

    private static String outline(Shape shape, double scale) {
        StringBuilder out = new StringBuilder();
        double[] points = new double[6];
        for (PathIterator path = shape.getPathIterator(null, 0.002); !path.isDone(); path.next()) {
            switch (path.currentSegment(points)) {
                case PathIterator.SEG_MOVETO ->
                    out.append(Html.format("M%.1f %.1f", points[0] * scale, points[1] * scale));
                case PathIterator.SEG_LINETO ->
                    out.append(Html.format("L%.1f %.1f", points[0] * scale, points[1] * scale));
                default -> out.append('Z');
            }
        }
        return out.toString();
    }

    /** Returns a path without points that are less than a unit of the chart from the one before. */
    private static String line(RobotPath path, double scale) {
        StringBuilder out = new StringBuilder();
        double lastX = Double.NaN;
        double lastY = Double.NaN;
        for (int i = 0; i < path.size(); i++) {
            double x = path.x(i) * scale;
            double y = path.y(i) * scale;
            if (!(StrictMath.hypot(x - lastX, y - lastY) < 1) || i == path.size() - 1) {
                out.append(out.isEmpty() ? "M" : "L").append(Html.format("%.1f %.1f", x, y));
                lastX = x;
                lastY = y;
            }
        }
        return out.toString();
    }

    /** Returns which line is which controller's. */
    static String legend(List<ControllerRuns> controllers) {
        StringBuilder out = new StringBuilder("<p>");
        for (int i = 0; i < controllers.size(); i++) {
            out.append("<svg width=\"34\" height=\"10\" aria-hidden=\"true\"><path d=\"M2 5H32\" ")
                    .append(stroke(i, 2.4))
                    .append("/></svg> <code>")
                    .append(Html.escape(controllers.get(i).controller()))
                    .append("</code>&emsp;");
        }
        return out.append("</p>\n").toString();
    }

    /** Returns a row for each controller: a dot for each run, and the interval of the mean. */
    static String spread(Metric metric, List<ControllerRuns> controllers) {
        double[] all = controllers.stream()
                .flatMapToDouble(controller -> Arrays.stream(metric.values(controller.runs())))
                .toArray();
        boolean share = metric == Metric.COLLISION;
        double low = share ? 0 : Arrays.stream(all).min().orElse(0);
        double high = share ? 1 : Math.max(Arrays.stream(all).max().orElse(1), low + 1e-9);
        double scale = (SPREAD_WIDTH - 2 * MARGIN) / (high - low);
        int height = ROW * controllers.size() + 2 * ROW;
        StringBuilder out = new StringBuilder(Svg.open(SPREAD_WIDTH, height, metric.meaning()));
        out.append(Svg.text("label", "middle", SPREAD_WIDTH / 2.0, 14, metric.meaning()));
        for (int i = 0; i < controllers.size(); i++) {
            double[] values = metric.values(controllers.get(i).runs());
            int y = ROW + ROW * i + ROW / 2;
            out.append(Svg.path("grid", Html.format("M%d %dH%d", MARGIN, y, SPREAD_WIDTH - MARGIN)));
            if (values.length > 1) {
                Interval mean = metric.interval(values);
                out.append(Html.format(
                        "<path %s d=\"M%.1f %dH%.1f\"/>",
                        stroke(i, 5),
                        MARGIN + (Math.max(low, mean.low()) - low) * scale,
                        y,
                        MARGIN + (Math.min(high, mean.high()) - low) * scale));
            }
            for (double value : values) {
                out.append(Html.format(
                        "<circle cx=\"%.1f\" cy=\"%d\" r=\"4\" fill=\"%s\" fill-opacity=\"0.6\"/>",
                        MARGIN + (value - low) * scale, y, colour(i)));
            }
        }
        out.append(Svg.text("tick", "start", MARGIN, height - 8, metric.format(low)));
        out.append(Svg.text("tick", "end", SPREAD_WIDTH - MARGIN, height - 8, metric.format(high)));
        return out.append("</svg>\n").toString();
    }
}
