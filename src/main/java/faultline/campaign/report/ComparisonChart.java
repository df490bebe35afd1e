package faultline.campaign.report;

import faultline.engine.RobotPath;
import faultline.engine.SimulationSetup;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Series;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.SvgSurface;
import faultline.world.WorldSpec;
import java.awt.BasicStroke;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** The pictures of a comparison. Each controller has the colour and the dash pattern of a series. */
final class ComparisonChart {

    private static final double MAX_WIDTH = 900;
    private static final double MAX_HEIGHT = 760;
    private static final double MARGIN = 14;
    private static final double FIRST_WIDTH = 2.2;
    private static final double OTHER_WIDTH = 1;
    private static final double END_RADIUS = 3;
    private static final double CROSS_RADIUS = 5;

    /** The maximum distance of a drawn path from the path of the run, pixels. */
    private static final double TOLERANCE = 0.25;

    /** The number of seeds whose runs are drawn. More lines, a pixel wide, would only hide each other. */
    static final int MAX_DRAWN = 100;

    private static final double START_OPACITY = 0.4;

    /** Half the height of the bar of an interval, in rows. */
    private static final double HALF_BAR = 0.2;

    /** The minimum span of an axis, relative to its greatest value and in its unit. */
    private static final double MIN_SPAN = 1e-3;

    private ComparisonChart() {}

    private static LineStyle style(int controller) {
        return ReportCharts.STYLE.lineStyle(controller);
    }

    /** Returns pixels per metre. */
    private static double scale(WorldSpec world) {
        return Math.min((MAX_WIDTH - 2 * MARGIN) / world.width(), (MAX_HEIGHT - 2 * MARGIN) / world.height());
    }

    /** Returns the points of a path that are drawn. */
    static List<Vector2> drawnPath(RobotPath path, WorldSpec world) {
        return path.simplified(TOLERANCE / scale(world));
    }

    /** Returns the world with the paths of the runs that are drawn, their common start, and their ends. */
    static String paths(SimulationSetup setup, List<ControllerRuns> controllers) {
        double width = setup.world().width();
        double height = setup.world().height();
        double scale = scale(setup.world());
        SvgSurface surface = new SvgSurface(
                (int) Math.ceil(width * scale + 2 * MARGIN), (int) Math.ceil(height * scale + 2 * MARGIN));
        PlanView plan = new PlanView(
                surface,
                new PixelRectangle(MARGIN, MARGIN, width * scale, height * scale),
                new Rectangle2D.Double(0, 0, width, height),
                ReportCharts.STYLE);
        plan.drawWorld(setup.world());
        plan.drawRobot(setup.robot(), setup.start(), START_OPACITY);
        for (int i = 0; i < controllers.size(); i++) {
            List<ControllerRuns.ComparedRun> runs = controllers.get(i).drawnRuns();
            for (int j = runs.size() - 1; j >= 0; j--) {
                boolean isFirst = runs.get(j).seed() == setup.seed();
                List<Vector2> points = runs.get(j).path();
                plan.drawLine(points, style(i).withWidth(isFirst ? FIRST_WIDTH : OTHER_WIDTH));
                Vector2 end = plan.toPicture(points.get(points.size() - 1));
                drawEnd(surface, end, runs.get(j).collided(), style(i));
            }
        }
        return surface.toHtml("chart", "Paths of the controllers");
    }

    private static void drawEnd(SvgSurface surface, Vector2 end, boolean collided, LineStyle style) {
        if (!collided) {
            surface.fill(Shapes.circle(end, END_RADIUS), style.colour());
            return;
        }
        Vector2 falling = new Vector2(CROSS_RADIUS, CROSS_RADIUS);
        Vector2 rising = new Vector2(CROSS_RADIUS, -CROSS_RADIUS);
        for (Vector2 half : List.of(falling, rising)) {
            surface.draw(
                    Shapes.polyline(List.of(end.minus(half), end.plus(half))), style.colour(), new BasicStroke((float)
                            FIRST_WIDTH));
        }
    }

    /** Returns the legend: the number and the line of each controller. */
    static String legend(List<ControllerRuns> controllers) {
        StringBuilder out = new StringBuilder("<ol class=\"legend\">\n");
        for (int i = 0; i < controllers.size(); i++) {
            SvgSurface sample = new SvgSurface(34, 10);
            Vector2 left = new Vector2(2, 5);
            sample.draw(Shapes.polyline(List.of(left, left.plus(new Vector2(30, 0)))), style(i).withWidth(FIRST_WIDTH));
            String name = Html.escape(controllers.get(i).controller());
            out.append("<li>" + sample.toHtml("sample", "") + " <code>" + name + "</code></li>\n");
        }
        return out.append("</ol>\n").toString();
    }

    /**
     * Returns a row for each controller: a mark for each run, and the interval of the mean; a sentence if no run has
     * the number.
     */
    static String spread(Metric metric, List<ControllerRuns> controllers) {
        if (controllers.stream().allMatch(runs -> metric.values(runs.runs()).length == 0)) {
            return Html.paragraph("No data: " + metric.meaning() + ".");
        }
        List<Series> series = new ArrayList<>();
        DoubleStream.Builder shown = DoubleStream.builder();
        for (int i = 0; i < controllers.size(); i++) {
            double[] values = metric.values(controllers.get(i).countedRuns());
            int row = controllers.size() - 1 - i;
            if (values.length > 1) {
                Interval mean = metric.interval(values);
                shown.add(mean.low()).add(mean.high());
                series.add(new Series.Band("", edge(mean, row + HALF_BAR), edge(mean, row - HALF_BAR), i));
            }
            Arrays.stream(values).forEach(shown);
            series.add(new Series.Points(
                    "",
                    Arrays.stream(values)
                            .mapToObj(value -> new Vector2(value, row))
                            .toList(),
                    i));
        }
        if (metric == Metric.COLLISION) {
            shown.add(0).add(1);
        }
        double[] covered = shown.build().toArray();
        double most = Arrays.stream(covered).map(Math::abs).max().orElse(1);
        return ReportCharts.rows(
                metric.meaning(),
                Axis.covering(metric.meaning(), Arrays.stream(covered), MIN_SPAN * Math.max(1, most)),
                IntStream.rangeClosed(1, controllers.size())
                        .mapToObj(Integer::toString)
                        .toList(),
                series);
    }

    private static List<Vector2> edge(Interval interval, double y) {
        return List.of(new Vector2(interval.low(), y), new Vector2(interval.high(), y));
    }
}
