package faultline.gui.instrument;

import faultline.engine.record.Level;
import faultline.gui.theme.Theme;
import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The values of a chart's lines at the moment under the mouse, as texts and as a plate on the chart. */
final class ReadOut {

    private static final int PADDING = 6;
    private static final int ROW = 15;
    private static final int AWAY = 10;

    private final StripScale chart;
    private final long bucket;

    ReadOut(StripScale chart, double time) {
        this.chart = chart;
        this.bucket = chart.data().bucket(time);
    }

    boolean isEmpty() {
        return bucket < 0;
    }

    /** The moment, then one line a curve. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(format("t %.3f s", chart.data().time(bucket)));
        for (int i = chart.signal().curves().size() - 1; i >= 0; i--) {
            Curve curve = chart.signal().curves().get(i);
            lines.add(curve.name() + " " + value(curve));
        }
        return lines;
    }

    private String value(Curve curve) {
        Level level = chart.data().level();
        float low = level.low(curve.channel(), bucket);
        float high = level.high(curve.channel(), bucket);
        if (!Float.isFinite(low)) {
            return "–";
        }
        String least = format("%.3f", low);
        String most = format("%.3f", high);
        return (least.equals(most) ? least : least + " … " + most) + " " + chart.signal().unit();
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    void paint(Graphics2D g, Theme theme) {
        double x = chart.x(chart.data().time(bucket));
        g.setColor(theme.palette().muted());
        g.setStroke(new BasicStroke(1));
        g.draw(new Line2D.Double(x, chart.plot().getY(), x, chart.plot().getMaxY()));
        chart.signal().curves().forEach(curve -> dot(g, theme, curve, x));
        plate(g, theme, x);
    }

    private void dot(Graphics2D g, Theme theme, Curve curve, double x) {
        float value = chart.data().level().high(curve.channel(), bucket);
        if (Float.isFinite(value)) {
            g.setColor(curve.colour().apply(theme));
            g.fill(new Ellipse2D.Double(x - 3, chart.y(value) - 3, 6, 6));
        }
    }

    /** Beside the moment, on the side that has room. */
    private void plate(Graphics2D g, Theme theme, double x) {
        FontMetrics metrics = g.getFontMetrics();
        List<String> lines = lines();
        double width = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0) + 2 * PADDING;
        double beside = x + AWAY + width < chart.plot().getMaxX() ? x + AWAY : x - AWAY - width;
        double left = Math.max(beside, chart.plot().getX());
        Shape plate = new RoundRectangle2D.Double(left, chart.plot().getY() + 4, width, lines.size() * ROW + PADDING, 6, 6);
        g.setColor(theme.palette().canvas());
        g.fill(plate);
        g.setColor(theme.colours().border());
        g.draw(plate);
        g.setColor(theme.palette().text());
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), (float) (left + PADDING), (float) (chart.plot().getY() + 4 + (i + 1) * ROW - 1));
        }
    }
}
