package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import faultline.paint.chart.Axis;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.stream.DoubleStream;

/** The left reading over the spin clock, with F3, F4, and t_p back from F4 to the middle of t_D. */
final class AlignmentChart {

    private static final Font SMALL_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final Stroke DASHED =
            new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {5, 4}, 0);
    private static final double ARROWHEAD_SIZE = 5;

    private final Graphics2D g;
    private final Theme theme;
    private final AlignmentTrace spin;
    private final Rectangle2D plot;
    private final Axis clock;
    private final Axis reading;

    AlignmentChart(Graphics2D g, Theme theme, AlignmentTrace spin, Rectangle2D plot) {
        this.g = g;
        this.theme = theme;
        this.spin = spin;
        this.plot = plot;
        clock = Axis.covering(
                "s",
                DoubleStream.concat(
                        DoubleStream.of(0, 0.5), spin.samples().stream().mapToDouble(AlignmentTrace.Sample::clock)));
        reading = Axis.covering(
                "m",
                DoubleStream.concat(
                        DoubleStream.of(0, 0.2), spin.samples().stream().mapToDouble(AlignmentTrace.Sample::reading)));
        g.setFont(SMALL_FONT);
    }

    void paint() {
        paintGrid();
        paintReadings();
        if (spin.isTimed()) {
            paintMark(spin.f3(), Messages.get("spin.f3"));
            paintMark(spin.f4(), Messages.get("spin.f4"));
            paintDuration(spin.f3(), spin.f4(), height(0.5), Messages.get("spin.tD"), true);
            paintDuration(spin.f4(), spin.f4() - spin.tP(), height(0.28), Messages.get("spin.tP"), false);
        }
        paintRobotClock();
    }

    private double x(double time) {
        return plot.getX() + clock.fractionOf(time) * plot.getWidth();
    }

    private double y(double metres) {
        return plot.getMaxY() - reading.fractionOf(metres) * plot.getHeight();
    }

    /** A share of the height from below; readings mostly leave the lower half free. */
    private double height(double share) {
        return plot.getMaxY() - share * plot.getHeight();
    }

    private void paintGrid() {
        for (double tick : reading.ticks()) {
            drawGridLine(plot.getX(), y(tick), plot.getMaxX(), y(tick));
            String name = Axis.formatTick(tick);
            drawText(
                    name,
                    plot.getX() - 6 - width(name),
                    y(tick) + 4,
                    theme.palette().muted());
        }
        for (double tick : clock.ticks()) {
            drawGridLine(x(tick), plot.getY(), x(tick), plot.getMaxY());
            String name = Axis.formatTick(tick) + " s";
            drawText(
                    name,
                    x(tick) - width(name) / 2,
                    plot.getMaxY() + 22,
                    theme.palette().muted());
        }
        drawText(
                Messages.get("spin.reading"),
                plot.getX(),
                plot.getY() - 9,
                theme.palette().text());
    }

    private void drawGridLine(double x0, double y0, double x1, double y1) {
        drawLine(x0, y0, x1, y1, theme.palette().gridMajor(), new BasicStroke(1));
    }

    private void drawLine(double x0, double y0, double x1, double y1, Color colour, Stroke stroke) {
        g.setColor(colour);
        g.setStroke(stroke);
        g.draw(new Line2D.Double(x0, y0, x1, y1));
    }

    private double width(String text) {
        return g.getFontMetrics().stringWidth(text);
    }

    private void drawText(String text, double x, double y, Color colour) {
        g.setColor(colour);
        g.drawString(text, (float) x, (float) y);
    }

    private void paintReadings() {
        Path2D line = new Path2D.Double();
        boolean drawing = false;
        for (AlignmentTrace.Sample sample : spin.samples()) {
            if (Double.isFinite(sample.reading()) && drawing) {
                line.lineTo(x(sample.clock()), y(sample.reading()));
            } else if (Double.isFinite(sample.reading())) {
                line.moveTo(x(sample.clock()), y(sample.reading()));
            }
            drawing = Double.isFinite(sample.reading());
        }
        g.setColor(theme.palette().path());
        g.setStroke(Antialiasing.roundStroke(2));
        g.draw(line);
    }

    private void paintMark(double time, String name) {
        drawLine(x(time), plot.getY(), x(time), plot.getMaxY(), theme.palette().contact(), DASHED);
        drawText(name, x(time) + 4, plot.getMaxY() - 5, theme.palette().text());
    }

    /** An arrow from time to time with its name; both ends have heads where it is a length and not a turn. */
    private void paintDuration(double from, double to, double y, String name, boolean bothWays) {
        ThemeColours colours = theme.colours();
        drawLine(x(from), y, x(to), y, colours.accent(), Antialiasing.roundStroke(1.5));
        g.fill(arrowhead(x(to), y, Math.signum(x(to) - x(from))));
        if (bothWays) {
            g.fill(arrowhead(x(from), y, Math.signum(x(from) - x(to))));
        }
        double middle = (x(from) + x(to)) / 2;
        Vector2 corner = new Vector2(middle - width(name) / 2, y);
        g.setColor(theme.palette().canvas());
        g.fill(new Rectangle2D.Double(corner.x() - 3, y - 6, width(name) + 6, 12));
        drawText(name, corner.x(), y + 4, theme.palette().text());
    }

    private static Path2D arrowhead(double x, double y, double sign) {
        Path2D head = new Path2D.Double();
        head.moveTo(x, y);
        head.lineTo(x - sign * 2 * ARROWHEAD_SIZE, y - ARROWHEAD_SIZE);
        head.lineTo(x - sign * 2 * ARROWHEAD_SIZE, y + ARROWHEAD_SIZE);
        head.closePath();
        return head;
    }

    /** Where on the clock the robot's heading is now: it comes back from F4. */
    private void paintRobotClock() {
        double x = x(spin.clockAt(spin.headingNow()));
        if (x >= plot.getX() - 1 && x <= plot.getMaxX() + 1) {
            g.setColor(theme.palette().robotOutline());
            g.fill(new Ellipse2D.Double(x - 4, plot.getMaxY() - 4, 8, 8));
        }
    }
}
