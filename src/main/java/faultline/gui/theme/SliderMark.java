package faultline.gui.theme;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.function.Function;

/** A mark at a value on the track of a slider, with a colour by theme and the text of its tool tip. */
public record SliderMark(int value, MarkShape form, Function<Theme, Color> colour, String text) {

    private static final double TICK_LENGTH = 12;
    private static final double RADIUS = 4.5;

    /** The shapes, which differ so that no meaning depends on colour alone. */
    public enum MarkShape {
        /** A short line across the track. */
        TICK,
        /** A disc. */
        DISC
    }

    /** Paints the mark at a point of the track. */
    void paint(Graphics2D g, double x, double y) {
        if (form == MarkShape.DISC) {
            g.setColor(Theme.currentColours().background());
            g.fill(new Ellipse2D.Double(x - RADIUS - 1, y - RADIUS - 1, 2 * RADIUS + 2, 2 * RADIUS + 2));
        }
        g.setColor(colour.apply(Theme.current()));
        g.fill(
                form == MarkShape.DISC
                        ? new Ellipse2D.Double(x - RADIUS, y - RADIUS, 2 * RADIUS, 2 * RADIUS)
                        : new Rectangle2D.Double(x - 0.75, y - TICK_LENGTH / 2, 1.5, TICK_LENGTH));
    }
}
