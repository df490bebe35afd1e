package faultline.gui.instrument;

import faultline.gui.theme.Smooth;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.List;
import javax.swing.JComponent;

/** What the lines of a strip chart are called. */
final class StripLegend extends JComponent {

    private static final int SAMPLE = 26;
    private static final int GAP = 6;
    private static final int APART = 16;
    private static final int HEIGHT = 20;

    private transient List<Curve> curves = List.of();

    StripLegend() {
        setFont(TextSize.font(Font.PLAIN, 11));
    }

    void setSignal(Signal signal) {
        curves = signal.curves();
        revalidate();
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        int width = curves.stream().mapToInt(this::width).sum() + Math.max(0, curves.size() - 1) * APART;
        return new Dimension(width, TextSize.scaled(HEIGHT));
    }

    private int width(Curve curve) {
        return SAMPLE + GAP + getFontMetrics(getFont()).stringWidth(curve.name());
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    public Dimension getMaximumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Smooth.paint(graphics, g -> {
            g.setFont(getFont());
            // Where the bar is too short, names that do not fit are left out.
            int room = getParent().getWidth() - getX();
            double x = 0;
            for (int i = curves.size() - 1; i >= 0 && x + width(curves.get(i)) <= room; i--) {
                x = paint(g, curves.get(i), x) + APART;
            }
        });
    }

    private double paint(Graphics2D g, Curve curve, double x) {
        g.setColor(curve.colour().apply(Theme.current()));
        g.setStroke(curve.stroke());
        double middle = getHeight() / 2.0;
        g.draw(new Line2D.Double(x, middle, x + SAMPLE, middle));
        g.setColor(Theme.now().text());
        g.drawString(curve.name(), (float) (x + SAMPLE + GAP), (float) (middle + g.getFontMetrics().getAscent() / 2.0 - 2));
        return x + SAMPLE + GAP + g.getFontMetrics().stringWidth(curve.name());
    }
}
