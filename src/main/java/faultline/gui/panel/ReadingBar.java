package faultline.gui.panel;

import faultline.gui.text.Texts;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import faultline.world.SensorSnapshot;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.RoundRectangle2D;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.UIManager;

/** What a sensor reports: as a share of its range, as a number, and with a sign where it is faulty. */
final class ReadingBar extends JComponent {

    private static final int BAR = 38;
    private static final int THICKNESS = 8;
    private static final int SIGN = 14;
    private static final int GAP = 3;
    private static final int HEIGHT = 20;

    private final String sensor;
    private final int width;
    private String text = "";
    private double share;
    private boolean faulty;

    ReadingBar(String sensor) {
        this.sensor = sensor;
        setFont(UIManager.getFont("Label.font"));
        this.width = BAR + GAP + getFontMetrics(getFont()).stringWidth("0.000") + GAP + SIGN;
        setPreferredSize(new Dimension(width, HEIGHT));
        setMinimumSize(getPreferredSize());
        getAccessibleContext().setAccessibleName(Texts.text("sensor.reading", sensor));
    }

    void show(SensorSnapshot snapshot) {
        double newShare = snapshot.reported().distance().orElse(0) / snapshot.spec().range();
        String newText = ReadingText.of(snapshot.reported());
        boolean newFaulty = !snapshot.faults().isEmpty();
        if (newShare != share || !newText.equals(text) || newFaulty != faulty) {
            share = newShare;
            text = newText;
            faulty = newFaulty;
            repaint();
        }
        describe(snapshot);
    }

    private void describe(SensorSnapshot snapshot) {
        String tip = Texts.text("sensor.reading", sensor) + ": " + text
                + (faulty ? " (" + Texts.text("sensor.faulty", ReadingText.of(snapshot.faults())) + ")" : "");
        if (!tip.equals(getToolTipText())) {
            setToolTipText(tip);
            getAccessibleContext().setAccessibleDescription(tip);
        }
    }

    /** The number as it shows. */
    String text() {
        return text;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        ThemeColours colours = Theme.now();
        Smooth.paint(graphics, g -> {
            double y = (getHeight() - THICKNESS) / 2.0;
            g.setColor(colours.line());
            g.fill(bar(y, BAR));
            if (share > 0) {
                g.setColor(colours.accent());
                g.fill(bar(y, Math.max(THICKNESS, BAR * Math.min(1, share))));
            }
            paintText(g);
            if (faulty) {
                Glyph.WARNING.paint(g, width - SIGN, (getHeight() - SIGN) / 2.0, SIGN, colours.warning());
            }
        });
    }

    private static RoundRectangle2D bar(double y, double length) {
        return new RoundRectangle2D.Double(0, y, length, THICKNESS, THICKNESS, THICKNESS);
    }

    private void paintText(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics(getFont());
        g.setFont(getFont());
        g.setColor(share > 0 ? Theme.now().text() : Theme.now().muted());
        g.drawString(text, width - SIGN - GAP - metrics.stringWidth(text), (getHeight() + metrics.getAscent() - metrics.getDescent()) / 2);
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.PROGRESS_BAR;
                }
            };
        }
        return accessibleContext;
    }
}
