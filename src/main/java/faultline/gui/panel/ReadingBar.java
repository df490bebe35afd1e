package faultline.gui.panel;

import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.ReadingText;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import faultline.paint.surface.Palette;
import faultline.sensor.Reading;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.RoundRectangle2D;
import java.util.function.Function;
import javax.accessibility.AccessibleRole;
import javax.swing.UIManager;

/**
 * Shows a true or reported reading as a number on a bar of its share of the range, the reported one in the sensor's
 * colour, with an icon if the sensor is faulty.
 */
final class ReadingBar extends AccessibleComponent {

    private static final int HEIGHT = 20;
    private static final int ARC = 6;
    private static final int PADDING = 5;
    private static final int WARNING_SIZE = 14;
    private static final int GAP = 3;
    /** In both themes, numbers on the bar have a contrast of at least 4.5. */
    static final int BAR_ALPHA = 80;

    private final int index;
    private final String sensor;
    private final ReadingKind readingKind;
    private int barWidth;
    private String text = "";
    /** The text with as many decimals as the bar has room for. */
    private String shownText = "";

    private double fillShare;
    private boolean faulty;

    /** The readings of a sensor. */
    enum ReadingKind {
        /** The true distance. */
        ACTUAL("sensor.true", SensorSnapshot::truth),
        /** The distance that the controller receives. */
        REPORTED("sensor.reading", SensorSnapshot::reported);

        private final String key;
        private final Function<SensorSnapshot, Reading> reading;

        ReadingKind(String key, Function<SensorSnapshot, Reading> reading) {
            this.key = key;
            this.reading = reading;
        }
    }

    /** Creates the bar of a sensor, given its index in the robot and its id. */
    ReadingBar(int index, String sensor, ReadingKind readingKind) {
        super(AccessibleRole.PROGRESS_BAR);
        this.index = index;
        this.sensor = sensor;
        this.readingKind = readingKind;
        RefreshSteps.add(this, ReadingBar::refresh);
    }

    private void refresh() {
        setFont(UIManager.getFont("Label.font"));
        barWidth = getFontMetrics(getFont()).stringWidth("0.000") + 2 * PADDING;
        setPreferredSize(new Dimension(
                barWidth + (readingKind == ReadingKind.REPORTED ? GAP + WARNING_SIZE : 0), TextSize.scaled(HEIGHT)));
        setMinimumSize(getPreferredSize());
        getAccessibleContext().setAccessibleName(Messages.get(readingKind.key, sensor));
    }

    /** Shows the reading of a sensor; returns whether the bar must be painted again. */
    boolean setSnapshot(SensorSnapshot snapshot) {
        Reading reading = readingKind.reading.apply(snapshot);
        double newShare = reading.distance().orElse(0) / snapshot.spec().range();
        String newText = ReadingText.format(reading);
        boolean newFaulty =
                readingKind == ReadingKind.REPORTED && !snapshot.faults().isEmpty();
        boolean changed = newShare != fillShare || !newText.equals(text) || newFaulty != faulty;
        if (changed) {
            fillShare = newShare;
            text = newText;
            shownText = ReadingText.formatShort(reading);
            faulty = newFaulty;
            repaint();
        }
        updateToolTip(snapshot);
        return changed;
    }

    private void updateToolTip(SensorSnapshot snapshot) {
        String value =
                text + (faulty ? " (" + Messages.get("sensor.faulty", FaultText.format(snapshot.faults())) + ")" : "");
        String tip = Messages.get(readingKind.key, sensor) + ": " + value;
        if (!tip.equals(getToolTipText())) {
            setToolTipText(tip);
            // A screen reader has read the name before.
            getAccessibleContext().setAccessibleDescription(value);
        }
    }

    /** Returns the displayed number. */
    String text() {
        return shownText;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        ThemeColours colours = Theme.currentColours();
        Antialiasing.paint(graphics, g -> {
            g.setColor(colours.hover());
            g.fill(new RoundRectangle2D.Double(0, 0, barWidth, getHeight(), ARC, ARC));
            Color fill = readingKind == ReadingKind.ACTUAL
                    ? colours.muted()
                    : Theme.current().palette().sensorColours(index).outline();
            g.setColor(Palette.withAlpha(fill, BAR_ALPHA));
            g.fill(new RoundRectangle2D.Double(
                    0, 0, fillShare > 0 ? Math.max(ARC, barWidth * Math.min(1, fillShare)) : 0, getHeight(), ARC, ARC));
            paintText(g);
            if (faulty) {
                Glyph.WARNING.paint(
                        g, barWidth + GAP, (getHeight() - WARNING_SIZE) / 2.0, WARNING_SIZE, colours.warning());
            }
        });
    }

    private void paintText(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics(getFont());
        g.setFont(getFont());
        g.setColor(
                fillShare > 0
                        ? Theme.currentColours().text()
                        : Theme.currentColours().muted());
        g.drawString(
                shownText,
                barWidth - PADDING - metrics.stringWidth(shownText),
                (getHeight() + metrics.getAscent() - metrics.getDescent()) / 2);
    }
}
