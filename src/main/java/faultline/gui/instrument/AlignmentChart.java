package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Plot;
import faultline.paint.chart.PlotPainter;
import faultline.paint.chart.TickStyle;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * Plots the reading on the side of the wall over the manoeuvre's time, with F3, F4, and t_p from F4 back to the middle
 * of t_D.
 */
final class AlignmentChart {

    private static final double TEXT_SIZE = 11;
    private static final double ARROWHEAD_SIZE = 10;

    private final Surface surface;
    private final Theme theme;
    private final AlignmentTrace trace;
    /** The index of the sensor whose reading is plotted, -1 if it is that of the local map. */
    private final int sensor;

    private final Plot plot;
    private final PlotPainter painter;
    private final TextStyle textStyle;

    AlignmentChart(Surface surface, Theme theme, AlignmentTrace trace, int sensor, PixelRectangle area) {
        this.sensor = sensor;
        this.surface = surface;
        this.theme = theme;
        this.trace = trace;
        plot = new Plot(
                area,
                Axis.covering(
                        "s",
                        DoubleStream.concat(
                                DoubleStream.of(0, 0.5),
                                trace.samples().stream().mapToDouble(AlignmentTrace.AlignmentSample::clock))),
                Axis.covering(
                        "m",
                        DoubleStream.concat(
                                DoubleStream.of(0, 0.2),
                                trace.samples().stream().mapToDouble(AlignmentTrace.AlignmentSample::reading))));
        painter = new PlotPainter(surface, plot);
        textStyle = TextStyle.plain(TEXT_SIZE, theme.palette().text());
    }

    void paint() {
        painter.paintGrid(LineStyle.solid(theme.palette().gridMajor(), 1));
        painter.paintTicks(
                new TickStyle(TextStyle.plain(TEXT_SIZE, theme.palette().muted()), 0, 6, 22, " s"));
        surface.drawText(
                Messages.get("spin.reading", trace.wallSide().fileName()),
                new Vector2(plot.area().x(), plot.area().y() - 9),
                textStyle);
        painter.paintLine(
                trace.samples().stream()
                        .map(sample -> new Vector2(sample.clock(), sample.reading()))
                        .toList(),
                LineStyle.solid(lineColour(), 2));
        if (trace.isTimed()) {
            paintEdge(trace.f3(), Messages.get("spin.f3"));
            paintEdge(trace.f4(), Messages.get("spin.f4"));
            paintDuration(trace.f3(), trace.f4(), 0.5, Messages.get("spin.tD"), true);
            paintDuration(trace.f4(), trace.f4() - trace.tP(), 0.28, Messages.get("spin.tP"), false);
        }
        paintRobotClock();
    }

    private Color lineColour() {
        return sensor < 0
                ? theme.palette().robot()
                : theme.palette().sensorColours(sensor).outline();
    }

    private void paintEdge(double time, String name) {
        double bottom = plot.area().y() + plot.area().height();
        surface.draw(
                Shapes.polyline(List.of(new Vector2(plot.x(time), plot.area().y()), new Vector2(plot.x(time), bottom))),
                new LineStyle(theme.palette().contact(), 1.5, DashPattern.DASHED));
        surface.drawText(name, new Vector2(plot.x(time) + 4, bottom - 5), textStyle);
    }

    /**
     * Paints an arrow from one time to another with its name.
     *
     * @param share its height, as a fraction of the plot; readings mostly leave the lower half free
     * @param bothWays whether both ends have heads, as those of a length have, but not those of a turn
     */
    private void paintDuration(double from, double to, double share, String name, boolean bothWays) {
        double y = plot.area().pointAt(0, share).y();
        Vector2 start = new Vector2(plot.x(from), y);
        Vector2 tip = new Vector2(plot.x(to), y);
        LineStyle line = LineStyle.solid(theme.colours().accent(), 1.5);
        Vector2 direction = new Vector2(Math.signum(tip.x() - start.x()), 0);
        surface.draw(Shapes.polyline(List.of(start, tip)), line);
        surface.fill(Shapes.arrowhead(tip, direction, ARROWHEAD_SIZE, ARROWHEAD_SIZE), line.colour());
        if (bothWays) {
            surface.fill(Shapes.arrowhead(start, direction.times(-1), ARROWHEAD_SIZE, ARROWHEAD_SIZE), line.colour());
        }
        double width = textStyle.estimateWidth(name.replace("_", ""));
        double middle = (start.x() + tip.x()) / 2;
        surface.fill(
                new Rectangle2D.Double(middle - width / 2 - 3, y - 6, width + 6, 12),
                theme.palette().canvas());
        surface.drawText(name, new Vector2(middle, y + 4), textStyle.withAnchor(Anchor.MIDDLE));
    }

    /** Paints the clock reading of the robot's current heading, which comes back from F4. */
    private void paintRobotClock() {
        double x = plot.x(trace.clockAt(trace.headingNow()));
        PixelRectangle area = plot.area();
        if (x >= area.x() - 1 && x <= area.x() + area.width() + 1) {
            surface.fill(
                    Shapes.circle(new Vector2(x, area.y() + area.height()), 4),
                    theme.palette().robotOutline());
        }
    }
}
