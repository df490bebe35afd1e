package faultline.gui.theme;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Scanner;

/** Parses the shapes of glyphs. */
final class GlyphParser {

    private final Path2D path = new Path2D.Double();
    private final Scanner scanner;

    private GlyphParser(String drawing) {
        scanner = new Scanner(drawing);
    }

    static Path2D parse(String drawing) {
        GlyphParser reader = new GlyphParser(drawing);
        while (reader.scanner.hasNext()) {
            reader.addCommand(reader.scanner.next());
        }
        return reader.path;
    }

    private void addCommand(String verb) {
        switch (verb) {
            case "M" -> path.moveTo(nextNumber(), nextNumber());
            case "L" -> path.lineTo(nextNumber(), nextNumber());
            case "C" ->
                path.curveTo(nextNumber(), nextNumber(), nextNumber(), nextNumber(), nextNumber(), nextNumber());
            case "O" -> addCircle(nextNumber(), nextNumber(), nextNumber());
            case "Z" -> path.closePath();
            default -> throw new IllegalArgumentException("no such verb in a glyph: " + verb);
        }
    }

    private void addCircle(double x, double y, double radius) {
        path.append(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius), false);
    }

    private double nextNumber() {
        return Double.parseDouble(scanner.next());
    }
}
