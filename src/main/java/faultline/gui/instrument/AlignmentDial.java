package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.Shapes;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;

/**
 * Draws the headings of an alignment manoeuvre seen from above, as on the canvas: the sector of t_D, its dashed
 * bisector, and the robot's heading as a needle.
 */
final class AlignmentDial {

    private static final Stroke DASHED = DrawContext.dashedStroke(1.8, 5, 4);
    private static final int SECTOR_ALPHA = 60;
    private static final double ARROWHEAD_SIZE = 9;

    private final Graphics2D g;
    private final Theme theme;
    private final double x;
    private final double y;
    private final double radius;

    AlignmentDial(Graphics2D g, Theme theme, double x, double y, double radius) {
        this.g = g;
        this.theme = theme;
        this.x = x;
        this.y = y;
        this.radius = radius;
    }

    void paint(AlignmentTrace spin) {
        paintCircle();
        if (spin.isTimed()) {
            paintSector(spin.headingAt(spin.f3()), spin.headingAt(spin.f4()));
            paintRay(spin.headingAt(spin.f3()), theme.palette().contact(), DASHED);
            paintRay(spin.headingAt(spin.f4()), theme.palette().contact(), DASHED);
            paintRay(spin.predictedHeading(), theme.colours().accent(), DASHED);
        }
        paintNeedle(spin.headingNow());
    }

    private void paintCircle() {
        g.setColor(theme.colours().border());
        g.setStroke(new BasicStroke(1));
        g.draw(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
        for (int i = 0; i < 12; i++) {
            double angle = i * Math.PI / 6;
            g.draw(new Line2D.Double(
                    x + 0.9 * radius * Math.cos(angle),
                    y - 0.9 * radius * Math.sin(angle),
                    x + radius * Math.cos(angle),
                    y - radius * Math.sin(angle)));
        }
    }

    private void paintSector(double from, double to) {
        g.setColor(Palette.withAlpha(theme.colours().accent(), SECTOR_ALPHA));
        g.fill(new Arc2D.Double(
                x - radius,
                y - radius,
                2 * radius,
                2 * radius,
                Math.toDegrees(from),
                Math.toDegrees(to - from),
                Arc2D.PIE));
    }

    private void paintRay(double heading, Color colour, Stroke stroke) {
        g.setColor(colour);
        g.setStroke(stroke);
        g.draw(new Line2D.Double(x, y, x + radius * Math.cos(heading), y - radius * Math.sin(heading)));
    }

    private void paintNeedle(double heading) {
        paintRay(heading, theme.palette().robotOutline(), DrawContext.solidStroke(2.5));
        Vector2 direction = new Vector2(Math.cos(heading), -Math.sin(heading));
        g.fill(Shapes.arrowhead(
                new Vector2(x, y).plus(direction.times(radius)), direction, ARROWHEAD_SIZE, ARROWHEAD_SIZE));
    }
}
