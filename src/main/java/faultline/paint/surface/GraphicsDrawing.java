package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.List;

/** A drawing on a graphics, such as a component's or a picture's. */
public final class GraphicsDrawing implements Drawing {

    private final Graphics2D graphics;

    /**
     * A drawing whose pixels are the graphics' user space.
     *
     * @param graphics where to; its hints, colour, font and stroke are changed
     */
    public GraphicsDrawing(Graphics2D graphics) {
        this.graphics = graphics;
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    @Override
    public void drawPolyline(List<Vector2> points, boolean closed, LineStyle pen) {
        if (points.size() > 1) {
            applyLineStyle(pen);
            graphics.draw(path(points, closed));
        }
    }

    @Override
    public void fillPolygon(List<Vector2> points, Color colour) {
        graphics.setColor(colour);
        graphics.fill(path(points, true));
    }

    @Override
    public void drawCircle(Vector2 centre, double radius, LineStyle pen) {
        applyLineStyle(pen);
        graphics.draw(circle(centre, radius));
    }

    @Override
    public void fillCircle(Vector2 centre, double radius, Color colour) {
        graphics.setColor(colour);
        graphics.fill(circle(centre, radius));
    }

    @Override
    public void drawText(String text, Vector2 at, TextStyle style) {
        graphics.setColor(style.colour());
        Font font =
                new Font(Font.SANS_SERIF, style.bold() ? Font.BOLD : Font.PLAIN, 1).deriveFont((float) style.size());
        List<Subscripts.TextRun> runs = Subscripts.split(text);
        double width = runs.stream().mapToDouble(run -> width(run, font)).sum();
        AffineTransform before = graphics.getTransform();
        graphics.translate(at.x(), at.y());
        if (!style.horizontal()) {
            graphics.rotate(-Math.PI / 2);
        }
        double x = -width * style.anchor().ordinal() / 2;
        for (Subscripts.TextRun run : runs) {
            graphics.setFont(runFont(run, font));
            graphics.drawString(
                    run.text(), (float) x, (float) (run.subscript() ? Subscripts.DROP_RATIO * style.size() : 0));
            x += width(run, font);
        }
        graphics.setTransform(before);
    }

    private double width(Subscripts.TextRun run, Font font) {
        return runFont(run, font)
                .getStringBounds(run.text(), graphics.getFontRenderContext())
                .getWidth();
    }

    private static Font runFont(Subscripts.TextRun run, Font font) {
        return run.subscript() ? font.deriveFont((float) (Subscripts.SIZE_RATIO * font.getSize2D())) : font;
    }

    private void applyLineStyle(LineStyle pen) {
        graphics.setColor(pen.colour());
        graphics.setStroke(stroke(pen));
    }

    private static Stroke stroke(LineStyle pen) {
        List<Double> lengths = pen.dash().lengths();
        float width = (float) pen.width();
        if (lengths.isEmpty()) {
            return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
        }
        float[] dashes = new float[lengths.size()];
        for (int i = 0; i < dashes.length; i++) {
            dashes[i] = lengths.get(i).floatValue();
        }
        return new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0);
    }

    private static Ellipse2D circle(Vector2 centre, double radius) {
        return new Ellipse2D.Double(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    }

    private static Path2D path(List<Vector2> points, boolean closed) {
        Path2D path = new Path2D.Double();
        path.moveTo(points.get(0).x(), points.get(0).y());
        points.subList(1, points.size()).forEach(point -> path.lineTo(point.x(), point.y()));
        if (closed) {
            path.closePath();
        }
        return path;
    }
}
