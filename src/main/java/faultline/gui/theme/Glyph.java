package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Scanner;

/**
 * The shapes of icons, on a square of 18 by 18. A shape is written as strokes and filled areas, in {@code M x y} move,
 * {@code L x y} line, {@code C x y x y x y} curve, {@code O x y r} circle and {@code Z} close.
 */
public enum Glyph {
    OPEN("M 2 14.5 L 2 4 L 7 4 L 8.5 6 L 14 6 L 14 8 M 2 14.5 L 4.5 8 L 16.5 8 L 14 14.5 Z", ""),
    SAVE(
            "M 3 3 L 12.5 3 L 15 5.5 L 15 15 L 3 15 Z M 6 3 L 6 7 L 11.5 7 L 11.5 3 "
                    + "M 5.5 15 L 5.5 10.5 L 12.5 10.5 L 12.5 15",
            ""),
    UNDO("M 6.5 3.5 L 3 7 L 6.5 10.5 M 3 7 L 10.5 7 C 16.5 7 16.5 14.5 10.5 14.5 L 7 14.5", ""),
    REDO("M 11.5 3.5 L 15 7 L 11.5 10.5 M 15 7 L 7.5 7 C 1.5 7 1.5 14.5 7.5 14.5 L 11 14.5", ""),
    SELECT("M 4 2.5 L 4 14 L 7.2 11.2 L 9.4 16 L 11.5 15 L 9.4 10.4 L 13.8 10.4 Z", ""),
    RECTANGLE("M 2 5 L 16 5 L 16 13 L 2 13 Z", ""),
    SQUARE("M 4 4 L 14 4 L 14 14 L 4 14 Z", ""),
    CIRCLE("O 9 9 6", ""),
    ELLIPSE("M 2 9 C 2 3.7 16 3.7 16 9 C 16 14.3 2 14.3 2 9 Z", ""),
    TRIANGLE("M 9 3 L 16 15 L 2 15 Z", ""),
    HEXAGON("M 16 9 L 12.5 15 L 5.5 15 L 2 9 L 5.5 3 L 12.5 3 Z", ""),
    ANGLE("M 3.5 3 L 8 3 L 8 10.5 L 15 10.5 L 15 15 L 3.5 15 Z", ""),
    WALL("M 3 14 L 3 6 L 10 6 L 15 12", "O 3 14 1.5 O 3 6 1.5 O 10 6 1.5 O 15 12 1.5"),
    POLYGON("M 3 6 L 9 3 L 15 7 L 12 15 L 8 10.5 L 4 14 Z", ""),
    RUN("", "M 5 3 L 15 9 L 5 15 Z"),
    PAUSE("", "M 4.5 3.5 L 7.5 3.5 L 7.5 14.5 L 4.5 14.5 Z M 10.5 3.5 L 13.5 3.5 L 13.5 14.5 L 10.5 14.5 Z"),
    STEP("", "M 4 3.5 L 11 9 L 4 14.5 Z M 12 3.5 L 14.5 3.5 L 14.5 14.5 L 12 14.5 Z"),
    RECORD("O 9 9 6.5", "O 9 9 3.6"),
    STEP_BACK("", "M 14 3.5 L 7 9 L 14 14.5 Z M 6 3.5 L 3.5 3.5 L 3.5 14.5 L 6 14.5 Z"),
    RESTART(
            "M 5.2 4.4 C 8.5 1.8 13.2 2.8 14.7 6.6 C 16.2 10.6 13.4 15 9 15 C 5.7 "
                    + "15 3 12.3 3 9 M 5.4 1.2 L 5 4.7 L 8.5 5.2",
            ""),
    FIT(
            "M 2.5 6.5 L 2.5 2.5 L 6.5 2.5 M 11.5 2.5 L 15.5 2.5 L 15.5 6.5 M 15.5 11.5 L "
                    + "15.5 15.5 L 11.5 15.5 M 6.5 15.5 L 2.5 15.5 L 2.5 11.5",
            ""),
    PATH("M 2.5 14.5 C 5 14.5 6 12 7 9 C 8 6 9 3.5 11 3.5 C 13 3.5 12.5 8.5 15.5 8.5", ""),
    FOLLOW("O 9 9 4.2 M 9 1.5 L 9 4.8 M 9 13.2 L 9 16.5 M 1.5 9 L 4.8 9 M 13.2 9 L 16.5 9", "O 9 9 1.4"),
    SUN(
            "O 9 9 3.2 M 9 1.5 L 9 3 M 9 15 L 9 16.5 M 1.5 9 L 3 9 M 15 9 L 16.5 9 M 3.7 3.7 L "
                    + "4.8 4.8 M 13.2 13.2 L 14.3 14.3 M 14.3 3.7 L 13.2 4.8"
                    + " M 4.8 13.2 L 3.7 14.3",
            ""),
    MOON(
            "M 7 2.5 C 5.5 8 9.5 12.5 15.2 11 C 14 14.2 10.5 16.2 7 15.2 C 3.4 "
                    + "14.2 1.4 10.6 2.4 7 C 3 4.8 4.8 3.1 7 2.5 Z",
            ""),
    WARNING("M 9 2.5 L 16.2 15 L 1.8 15 Z M 9 7 L 9 10.5", "O 9 12.8 1"),
    CHECK("M 3.5 9.5 L 7.5 13.5 L 14.5 4.5", ""),
    ADD("M 9 3.5 L 9 14.5 M 3.5 9 L 14.5 9", ""),
    REMOVE("M 5 5 L 13 13 M 13 5 L 5 13", ""),
    NOTE("O 9 9 7 M 9 8.3 L 9 12.8", "O 9 5.4 1"),
    QUESTION("O 9 9 7 M 6.9 7 C 6.9 4.2 11.1 4.2 11.1 7 C 11.1 8.6 9 8.8 9 10.6", "O 9 13 1"),
    FOLDER("M 2 14.5 L 2 4 L 7 4 L 8.5 6 L 16 6 L 16 14.5 Z", ""),
    NEW_FOLDER("M 2 14.5 L 2 4 L 7 4 L 8.5 6 L 16 6 L 16 14.5 Z M 9 8 L 9 12.5 M 6.8 10.2 L 11.2 10.2", ""),
    FILE("M 4 2.5 L 10.5 2.5 L 14 6 L 14 15.5 L 4 15.5 Z M 10.5 2.5 L 10.5 6 L 14 6", ""),
    UP("M 9 14.5 L 9 3.5 M 4.5 8 L 9 3.5 L 13.5 8", ""),
    HOME("M 2.5 9 L 9 3 L 15.5 9 M 4.5 7.5 L 4.5 15 L 13.5 15 L 13.5 7.5", ""),
    LIST("M 3 5 L 15 5 M 3 9 L 15 9 M 3 13 L 15 13", ""),
    DETAILS("M 7 5 L 15 5 M 7 9 L 15 9 M 7 13 L 15 13", "O 3.8 5 1 O 3.8 9 1 O 3.8 13 1"),
    FAULT("", "M 10.8 1.5 L 3.5 10.3 L 8 10.3 L 6.8 16.5 L 14.5 7.2 L 9.8 7.2 Z"),
    COLLISION(
            "",
            "M 9 0.8 L 10.8 5.4 L 15 3 L 12.9 7.3 L 17.2 9 L 12.9 10.7 L 15 15 L 10.8 12.7 "
                    + "L 9 17.2 L 7.2 12.7 L 3 15 L 5.1 10.7 L 0.8 9 L 5.1 7.3 L 3 3 L 7.2 5.4 Z"),
    TRANSITION("M 2.5 9 L 15.5 9 M 10.5 4.5 L 15.5 9 L 10.5 13.5", ""),
    STAIRS("M 2 15 L 2 11.3 L 6.6 11.3 L 6.6 7.4 L 11.2 7.4 L 11.2 3.5 L 16 3.5", ""),
    PULSE("M 1.5 9.5 L 5 9.5 L 7 4 L 10.3 14.5 L 12.3 9.5 L 16.5 9.5", ""),
    CLOCK("O 9 9 6.8 M 9 4.8 L 9 9 L 12 10.8", ""),
    FORK("M 9 16 L 9 10.5 L 4 3 M 9 10.5 L 14 3", ""),
    PROMPT("M 3 4.5 L 7.5 9 L 3 13.5 M 9 14 L 15.5 14", ""),
    PENCIL("M 3 15 L 4 11.3 L 12 3.3 L 14.7 6 L 6.7 14 Z", ""),
    DRIVE("M 2.5 6 L 15.5 6 L 15.5 12.5 L 2.5 12.5 Z M 5 9.3 L 9 9.3", "O 13 9.3 0.9");

    /** The side of the square on which glyphs are defined. */
    public static final int SIZE = 18;

    private final Path2D strokes;
    private final Path2D areas;

    Glyph(String strokes, String areas) {
        this.strokes = Parser.parse(strokes);
        this.areas = Parser.parse(areas);
    }

    /** Paints the shape in a square of the given size with the given upper left corner. */
    public void paint(Graphics graphics, double x, double y, double size, Color colour) {
        Antialiasing.paint(graphics, g -> {
            g.translate(x, y);
            g.scale(size / SIZE, size / SIZE);
            g.setColor(colour);
            g.setStroke(DrawContext.solidStroke(1.6));
            g.draw(strokes);
            g.fill(areas);
        });
    }

    /** Returns an icon in the foreground colour of its component, pale if that is disabled. */
    public GlyphIcon icon() {
        return new GlyphIcon(this, SIZE, null);
    }

    /** Parses the strokes or the areas of a glyph. */
    static final class Parser {
        private final Path2D path = new Path2D.Double();
        private final Scanner scanner;

        private Parser(String drawing) {
            scanner = new Scanner(drawing);
        }

        static Path2D parse(String drawing) {
            Parser parser = new Parser(drawing);
            while (parser.scanner.hasNext()) {
                parser.addCommand(parser.scanner.next());
            }
            return parser.path;
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
}
