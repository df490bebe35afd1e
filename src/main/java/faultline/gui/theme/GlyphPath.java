package faultline.gui.theme;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Scanner;

/** Reads the drawings of glyphs. */
final class GlyphPath {

    private final Path2D path = new Path2D.Double();
    private final Scanner words;

    private GlyphPath(String drawing) {
        words = new Scanner(drawing);
    }

    static Path2D parse(String drawing) {
        GlyphPath reader = new GlyphPath(drawing);
        while (reader.words.hasNext()) {
            reader.add(reader.words.next());
        }
        return reader.path;
    }

    private void add(String verb) {
        switch (verb) {
            case "M" -> path.moveTo(number(), number());
            case "L" -> path.lineTo(number(), number());
            case "C" -> path.curveTo(number(), number(), number(), number(), number(), number());
            case "O" -> circle(number(), number(), number());
            case "Z" -> path.closePath();
            default -> throw new IllegalArgumentException("no such verb in a glyph: " + verb);
        }
    }

    private void circle(double x, double y, double radius) {
        path.append(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius), false);
    }

    private double number() {
        return Double.parseDouble(words.next());
    }
}
