package faultline.gui.panel;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Contrast;
import faultline.paint.surface.SensorColours;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;

/** The number of a sensor on the colour of its cone, as on the canvas. */
final class SensorBadge extends JComponent {

    private static final int SIZE = 18;

    private final int index;
    private int size;
    private Font font;

    /** Creates the badge of the sensor with the given index. */
    SensorBadge(int index) {
        this.index = index;
        RefreshSteps.add(this, SensorBadge::updateSize);
    }

    private void updateSize() {
        size = TextSize.scaled(SIZE);
        font = TextSize.scaledFont(Font.BOLD, 11);
        setPreferredSize(new Dimension(size, size));
        setMinimumSize(getPreferredSize());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        SensorColours colours = Theme.current().palette().sensorColours(index);
        Antialiasing.paint(graphics, g -> {
            Shape box = Antialiasing.roundedRectangle(0, 0, size, size);
            g.setColor(colours.fill());
            g.fill(box);
            g.setColor(colours.outline());
            g.setStroke(new BasicStroke(1));
            g.draw(box);
            paintIndex(g, numberColour(colours.fill()));
        });
    }

    private void paintIndex(Graphics2D g, Color colour) {
        String number = Integer.toString(index + 1);
        Rectangle2D bounds =
                font.createGlyphVector(g.getFontRenderContext(), number).getVisualBounds();
        g.setFont(font);
        g.setColor(colour);
        g.drawString(number, (float) (size / 2.0 - bounds.getCenterX()), (float) (size / 2.0 - bounds.getCenterY()));
    }

    /** Returns black or white, whichever has the higher contrast. */
    static Color numberColour(Color fill) {
        return Contrast.of(Color.BLACK, fill) > Contrast.of(Color.WHITE, fill) ? Color.BLACK : Color.WHITE;
    }
}
