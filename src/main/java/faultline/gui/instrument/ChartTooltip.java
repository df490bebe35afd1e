package faultline.gui.instrument;

import faultline.gui.text.NumberText;
import faultline.gui.theme.Theme;
import faultline.paint.surface.PixelRectangle;
import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;

/** The values of a chart's lines at the time under the cursor, as text and as a box on the chart. */
final class ChartTooltip {

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final int PADDING = 6;
    private static final int SAMPLE_WIDTH = 8;
    private static final int SAMPLE_HEIGHT = 3;
    private static final int ROW_HEIGHT = 15;
    private static final int POINTER_DISTANCE = 10;

    private final StripScale chart;
    private final long bucket;

    ChartTooltip(StripScale chart, double time) {
        this.chart = chart;
        this.bucket = chart.data().bucketAt(time);
    }

    boolean isEmpty() {
        return bucket < 0;
    }

    /** Returns the time, then one text per line. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add("t "
                + NumberText.clock(chart.data().timeOf(bucket), chart.data().dt()) + " s");
        for (int i = chart.signal().lines().size() - 1; i >= 0; i--) {
            ChartLine curve = chart.signal().lines().get(i);
            lines.add(curve.name() + " " + valueText(curve));
        }
        return lines;
    }

    private String valueText(ChartLine curve) {
        return chart.data()
                .valuesOf(curve)
                .filter(values -> Float.isFinite(values.min(bucket)))
                .map(values -> rangeText(values.min(bucket), values.max(bucket)))
                .orElse("–");
    }

    private String rangeText(float low, float high) {
        String least = NumberText.format("%.3f", low);
        String most = NumberText.format("%.3f", high);
        return (least.equals(most) ? least : least + " … " + most) + " "
                + chart.signal().unit();
    }

    /** Paints the values in a picture of the given width and height, pixels. */
    void paint(Graphics2D g, Theme theme, double width, double height) {
        double x = chart.plot().x(chart.data().timeOf(bucket));
        g.setColor(theme.palette().muted());
        g.setStroke(new BasicStroke(1));
        g.draw(new Line2D.Double(x, area().y(), x, area().y() + area().height()));
        chart.signal().lines().forEach(curve -> paintDot(g, theme, curve, x));
        paintBox(g, theme, box(g.getFontMetrics(FONT), width, height));
    }

    private PixelRectangle area() {
        return chart.plot().area();
    }

    private void paintDot(Graphics2D g, Theme theme, ChartLine curve, double x) {
        chart.data().valuesOf(curve).ifPresent(values -> {
            float value = values.max(bucket);
            if (Float.isFinite(value)) {
                g.setColor(curve.colour().apply(theme));
                g.fill(new Ellipse2D.Double(x - 3, chart.plot().y(value) - 3, 6, 6));
            }
        });
    }

    /** Returns the box beside the marked time, on the side that has room, no wider than the picture. */
    Rectangle2D box(FontMetrics metrics, double pictureWidth, double pictureHeight) {
        List<String> lines = lines();
        double x = chart.plot().x(chart.data().timeOf(bucket));
        double width = Math.min(fullWidth(metrics), pictureWidth - 1);
        double beside = x + POINTER_DISTANCE + width < area().x() + area().width()
                ? x + POINTER_DISTANCE
                : Math.max(x - POINTER_DISTANCE - width, area().x());
        double rowHeight = Math.min(ROW_HEIGHT, (pictureHeight - PADDING - 1) / lines.size());
        double height = lines.size() * rowHeight + PADDING;
        return new Rectangle2D.Double(
                Math.max(0, Math.min(beside, pictureWidth - width - 1)),
                Math.max(0, Math.min(area().y() + 4, pictureHeight - height - 1)),
                width,
                height);
    }

    private double fullWidth(FontMetrics metrics) {
        return lines().stream().mapToInt(metrics::stringWidth).max().orElse(0) + SAMPLE_WIDTH + 3 * PADDING;
    }

    private void paintBox(Graphics2D g, Theme theme, Rectangle2D box) {
        double size = box.getWidth() / fullWidth(g.getFontMetrics(FONT));
        g.setFont(FONT.deriveFont((float) (FONT.getSize2D() * size)));
        List<String> lines = lines();
        double left = box.getX();
        double top = box.getY();
        double rowHeight = (box.getHeight() - PADDING) / lines.size();
        Shape background = new RoundRectangle2D.Double(left, top, box.getWidth(), box.getHeight(), 6, 6);
        g.setColor(theme.palette().canvas());
        g.fill(background);
        g.setColor(theme.colours().border());
        g.draw(background);
        g.setColor(theme.palette().text());
        double textLeft = left + SAMPLE_WIDTH + 2 * PADDING;
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), (float) textLeft, (float) (top + (i + 1) * rowHeight - 1));
        }
        paintSamples(g, theme, left + PADDING, top, rowHeight);
    }

    /** Paints the colour of each line before its name, because a narrow chart has no legend of all lines. */
    private void paintSamples(Graphics2D g, Theme theme, double left, double top, double rowHeight) {
        List<ChartLine> curves = chart.signal().lines();
        for (int i = 0; i < curves.size(); i++) {
            ChartLine curve = curves.get(curves.size() - 1 - i);
            double middle = top + (i + 2) * rowHeight - 1 - rowHeight / 3;
            g.setColor(curve.colour().apply(theme));
            g.fill(new Rectangle2D.Double(left, middle - SAMPLE_HEIGHT / 2.0, SAMPLE_WIDTH, SAMPLE_HEIGHT));
        }
    }
}
