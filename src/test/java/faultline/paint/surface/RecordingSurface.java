package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A surface that lists what is drawn. */
public final class RecordingSurface implements Surface {

    /** A shape that was filled, or drawn as a line. */
    public record DrawnShape(Shape shape, boolean filled, Color colour) {

        /** Returns its points, rounded to tenths, such as {@code fill 0.0,0.0 5.0,0.0 5.0,5.0 closed}. */
        @Override
        public String toString() {
            List<String> points = new ArrayList<>();
            double[] c = new double[6];
            for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
                points.add(i.currentSegment(c) == PathIterator.SEG_CLOSE ? "closed" : text(c[0], c[1]));
            }
            return (filled ? "fill " : "") + String.join(" ", points);
        }
    }

    private final List<DrawnShape> shapes = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();

    /** Returns the shapes in the order in which they were drawn, as texts. */
    public List<String> shapes() {
        return shapes.stream().map(DrawnShape::toString).toList();
    }

    /** Returns the shapes that were filled or drawn in a colour. */
    public List<DrawnShape> shapes(Color colour) {
        return shapes.stream().filter(drawn -> drawn.colour.equals(colour)).toList();
    }

    /** Returns the texts with their places and anchors, such as {@code speed at 5.0,7.5 START}. */
    public List<String> texts() {
        return List.copyOf(texts);
    }

    /** Forgets everything. */
    public void clear() {
        shapes.clear();
        texts.clear();
    }

    @Override
    public void fill(Shape shape, Color colour) {
        shapes.add(new DrawnShape(shape, true, colour));
    }

    @Override
    public void draw(Shape shape, Color colour, Stroke stroke) {
        shapes.add(new DrawnShape(shape, false, colour));
    }

    @Override
    public void drawText(String text, Vector2 at, TextStyle style) {
        texts.add(Stream.of(text, "at", text(at.x(), at.y()), style.anchor().name(), style.horizontal() ? "" : "up")
                .filter(word -> !word.isEmpty())
                .collect(Collectors.joining(" ")));
    }

    @Override
    public void drawText(String text, double x, double y, Color colour, Font font) {
        texts.add(text + " at " + text(x, y));
    }

    @Override
    public void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font) {
        drawText(text, x, y, colour, font);
    }

    @Override
    public FontRenderContext fontRenderContext() {
        return DrawContext.FONT_CONTEXT;
    }

    private static String text(double x, double y) {
        return Math.round(x * 10) / 10.0 + "," + Math.round(y * 10) / 10.0;
    }
}
