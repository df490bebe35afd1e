package faultline.gui.panel;

import faultline.gui.text.Texts;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import faultline.sensor.Reading;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.RoundRectangle2D;
import java.util.function.Function;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.UIManager;

/**
 * What a sensor should read or what it reports: as a number on a bar that is its share of the range, and with a sign where the sensor is
 * faulty.
 */
final class ReadingBar extends JComponent {

    private static final int HEIGHT = 20;
    private static final int ARC = 6;
    private static final int PADDING = 5;
    private static final int SIGN = 14;
    private static final int GAP = 3;
    private static final int BAR_ALPHA = 90;

    private final String sensor;
    private final Side side;
    private final int bar;
    private String text = "";
    private double share;
    private boolean faulty;

    /** Which of a sensor's two readings. */
    enum Side {
        /** What is really there. */
        TRUE("sensor.true", SensorSnapshot::truth),
        /** What the controller gets. */
        REPORTED("sensor.reading", SensorSnapshot::reported);

        private final String key;
        private final Function<SensorSnapshot, Reading> reading;

        Side(String key, Function<SensorSnapshot, Reading> reading) {
            this.key = key;
            this.reading = reading;
        }
    }

    ReadingBar(String sensor, Side side) {
        this.sensor = sensor;
        this.side = side;
        setFont(UIManager.getFont("Label.font"));
        bar = getFontMetrics(getFont()).stringWidth("0.000") + 2 * PADDING;
        setPreferredSize(new Dimension(bar + (side == Side.REPORTED ? GAP + SIGN : 0), TextSize.scaled(HEIGHT)));
        setMinimumSize(getPreferredSize());
        getAccessibleContext().setAccessibleName(Texts.text(side.key, sensor));
    }

    void show(SensorSnapshot snapshot) {
        Reading reading = side.reading.apply(snapshot);
        double newShare = reading.distance().orElse(0) / snapshot.spec().range();
        String newText = ReadingText.of(reading);
        boolean newFaulty = side == Side.REPORTED && !snapshot.faults().isEmpty();
        if (newShare != share || !newText.equals(text) || newFaulty != faulty) {
            share = newShare;
            text = newText;
            faulty = newFaulty;
            repaint();
        }
        describe(snapshot);
    }

    private void describe(SensorSnapshot snapshot) {
        String tip = Texts.text(side.key, sensor) + ": " + text
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

    /** Which of the sensor's readings it shows. */
    Side side() {
        return side;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        ThemeColours colours = Theme.now();
        Smooth.paint(graphics, g -> {
            g.setColor(colours.hover());
            g.fill(new RoundRectangle2D.Double(0, 0, bar, getHeight(), ARC, ARC));
            Color fill = side == Side.TRUE ? colours.muted() : colours.accent();
            g.setColor(ThemeColours.translucent(fill, BAR_ALPHA));
            g.fill(new RoundRectangle2D.Double(0, 0, share > 0 ? Math.max(ARC, bar * Math.min(1, share)) : 0, getHeight(), ARC, ARC));
            paintText(g);
            if (faulty) {
                Glyph.WARNING.paint(g, bar + GAP, (getHeight() - SIGN) / 2.0, SIGN, colours.warning());
            }
        });
    }

    private void paintText(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics(getFont());
        g.setFont(getFont());
        g.setColor(share > 0 ? Theme.now().text() : Theme.now().muted());
        g.drawString(text, bar - PADDING - metrics.stringWidth(text), (getHeight() + metrics.getAscent() - metrics.getDescent()) / 2);
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
