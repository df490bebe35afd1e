package faultline.gui.instrument;

import faultline.gui.theme.Smooth;
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

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final int SAMPLE = 26;
    private static final int GAP = 6;
    private static final int APART = 16;
    private static final int HEIGHT = 20;

    private transient List<Curve> curves = List.of();

    StripLegend() {
        setFont(FONT);
    }

    void setSignal(Signal signal) {
        curves = signal.curves();
        revalidate();
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        int width = curves.stream().mapToInt(curve -> SAMPLE + GAP + getFontMetrics(FONT).stringWidth(curve.name()) + APART).sum();
        return new Dimension(width, HEIGHT);
    }

    @Override
    public Dimension getMaximumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Smooth.paint(graphics, g -> {
            double x = 0;
            for (int i = curves.size() - 1; i >= 0; i--) {
                x = paint(g, curves.get(i), x) + APART;
            }
        });
    }

    private static double paint(Graphics2D g, Curve curve, double x) {
        g.setColor(curve.colour().apply(Theme.current()));
        g.setStroke(curve.stroke());
        g.draw(new Line2D.Double(x, HEIGHT / 2.0, x + SAMPLE, HEIGHT / 2.0));
        g.setColor(Theme.now().text());
        g.drawString(curve.name(), (float) (x + SAMPLE + GAP), HEIGHT / 2f + 4);
        return x + SAMPLE + GAP + g.getFontMetrics().stringWidth(curve.name());
    }
}
