package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.Theme;
import faultline.paint.chart.Axis;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Paints a strip chart: the ribbon of states, axes and lines. */
final class StripPainter {

    private static final int RIBBON_GAP = 6;
    private static final int RIBBON_HEIGHT = 15;

    private final Graphics2D g;
    private final Theme theme;
    private final StripScale scale;
    private final Rectangle2D plot;

    /** A painter of one picture; the graphics paints smooth edges. */
    StripPainter(Graphics2D g, Theme theme, StripScale scale) {
        this.g = g;
        this.theme = theme;
        this.scale = scale;
        this.plot = scale.plot();
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
    }

    void paint(List<StateIntervals.StateInterval> stays) {
        stays.forEach(this::paintState);
        paintGrid();
        Shape clip = g.getClip();
        g.clip(plot);
        scale.signal().lines().forEach(this::paintLine);
        g.setClip(clip);
        if (scale.isEmpty()) {
            String none = Messages.get("strip.none");
            drawText(
                    none,
                    plot.getCenterX() - g.getFontMetrics().stringWidth(none) / 2.0,
                    plot.getCenterY() - 4,
                    theme.palette().muted());
        }
    }

    private void drawText(String text, double x, double y, Color colour) {
        g.setColor(colour);
        g.drawString(text, (float) x, (float) y);
    }

    /** A state's name stands in its piece of the ribbon where there is room. */
    private void paintState(StateIntervals.StateInterval stay) {
        double from = Math.max(plot.getX(), scale.x(stay.start()));
        double to = Math.min(plot.getMaxX(), scale.x(stay.end()));
        if (to <= from) {
            return;
        }
        g.setColor(theme.colours().hover());
        g.fill(new Rectangle2D.Double(from, RIBBON_GAP, to - from, RIBBON_HEIGHT));
        g.setColor(theme.palette().muted());
        g.fill(new Rectangle2D.Double(from, RIBBON_GAP, 1.5, RIBBON_HEIGHT));
        String name = StateText.name(stay.state());
        double room = to - from - g.getFontMetrics().stringWidth(name);
        if (room > 8) {
            drawText(name, from + room / 2, RIBBON_GAP + 12, theme.palette().text());
        }
    }

    private void paintGrid() {
        FontMetrics metrics = g.getFontMetrics();
        g.setStroke(new BasicStroke(1));
        for (double tick : scale.values().ticks()) {
            drawGridLine(plot.getX(), scale.y(tick), plot.getMaxX(), scale.y(tick));
            String name = Axis.formatTick(tick);
            drawText(
                    name,
                    plot.getX() - 6 - metrics.stringWidth(name),
                    scale.y(tick) + 4,
                    theme.palette().muted());
        }
        for (double tick :
                Axis.linear("s", scale.span().start(), scale.span().end()).ticks()) {
            drawGridLine(scale.x(tick), plot.getY(), scale.x(tick), plot.getMaxY());
            String name = Axis.formatTick(tick) + " s";
            drawText(
                    name,
                    scale.x(tick) - metrics.stringWidth(name) / 2.0,
                    plot.getMaxY() + 15,
                    theme.palette().muted());
        }
        drawText(scale.signal().unit(), 4, RIBBON_GAP + 12, theme.palette().muted());
    }

    private void drawGridLine(double x0, double y0, double x1, double y1) {
        g.setColor(theme.palette().gridMajor());
        g.draw(new Line2D.Double(x0, y0, x1, y1));
    }

    private void paintLine(ChartLine curve) {
        g.setColor(curve.colour().apply(theme));
        g.setStroke(curve.stroke());
        Path2D line = new Path2D.Double();
        boolean drawing = false;
        for (long bucket = scale.data().from(); bucket < scale.data().to(); bucket++) {
            float low = scale.data().level().min(curve.channel(), bucket);
            drawing = Float.isFinite(low)
                    && appendRange(
                            line,
                            drawing,
                            scale.data().timeOf(bucket),
                            low,
                            scale.data().level().max(curve.channel(), bucket));
        }
        g.draw(line);
    }

    private boolean appendRange(Path2D line, boolean drawing, double time, float low, float high) {
        if (drawing) {
            line.lineTo(scale.x(time), scale.y(low));
        } else {
            line.moveTo(scale.x(time), scale.y(low));
            line.lineTo(scale.x(time), scale.y(low));
        }
        if (high > low) {
            line.lineTo(scale.x(time), scale.y(high));
        }
        return true;
    }
}
