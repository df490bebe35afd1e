package faultline.gui.instrument;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.List;
import javax.swing.JComponent;

/** The legend of a strip chart. */
final class StripLegend extends JComponent {

    private static final int SAMPLE_WIDTH = 26;
    private static final int GAP = 6;
    private static final int ENTRY_GAP = 16;
    private static final int HEIGHT = 20;

    private transient List<ChartLine> lines = List.of();

    StripLegend() {
        RefreshSteps.add(this, legend -> legend.setFont(TextSize.scaledFont(Font.PLAIN, 11)));
    }

    void setSignal(SignalGroup signal) {
        lines = signal.lines();
        revalidate();
        repaint();
    }

    @Override
    public Dimension getMaximumSize() {
        int width = lines.stream().mapToInt(this::width).sum() + Math.max(0, lines.size() - 1) * ENTRY_GAP;
        return new Dimension(width, TextSize.scaled(HEIGHT));
    }

    private int width(ChartLine curve) {
        return SAMPLE_WIDTH + GAP + getFontMetrics(getFont()).stringWidth(curve.name());
    }

    /** Returns no width: the legend gets the room that the controls leave. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, TextSize.scaled(HEIGHT));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Antialiasing.paint(graphics, g -> {
            g.setFont(getFont());
            // Names that do not fit are left out.
            int room = getParent().getWidth() - getX();
            double x = 0;
            for (int i = lines.size() - 1; i >= 0 && x + width(lines.get(i)) <= room; i--) {
                x = paint(g, lines.get(i), x) + ENTRY_GAP;
            }
        });
    }

    private double paint(Graphics2D g, ChartLine curve, double x) {
        g.setColor(curve.colour().apply(Theme.current()));
        g.setStroke(curve.style(Theme.current()).stroke());
        double middle = getHeight() / 2.0;
        g.draw(new Line2D.Double(x, middle, x + SAMPLE_WIDTH, middle));
        g.setColor(Theme.currentColours().text());
        g.drawString(curve.name(), (float) (x + SAMPLE_WIDTH + GAP), (float)
                (middle + g.getFontMetrics().getAscent() / 2.0 - 2));
        return x + SAMPLE_WIDTH + GAP + g.getFontMetrics().stringWidth(curve.name());
    }
}
