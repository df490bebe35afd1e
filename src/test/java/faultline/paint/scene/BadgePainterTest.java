package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class BadgePainterTest {

    private static final double SYMBOL_WIDTH = 12;
    private static final List<String> LINES = List.of("a first line", "a second line that is longer");

    private final RecordingSurface drawn = new RecordingSurface();
    private final DrawContext context =
            new DrawContext(drawn, new Camera(0, 0, 100, 400, 300), Palette.LIGHT, DrawContext.DEFAULT_FONT);

    /** A line is 17 pixels high, and 8 are free around the lines and on both sides of the symbol. */
    @Test
    void theLinesAreInAFilledFrameBesideTheSymbol() {
        Vector2 symbol = BadgePainter.paint(context, new Vector2(10, 20), LINES, SYMBOL_WIDTH, Color.RED, 1);
        double width = Math.ceil(context.measureText(LINES.get(1)).getWidth() + SYMBOL_WIDTH + 3 * 8);
        Rectangle2D frame = new Rectangle2D.Double(10.5, 20.5, width, 2 * 17 + 8);
        List<RecordingSurface.DrawnShape> filled = drawn.shapes(Palette.LIGHT.canvas());
        assertEquals(
                List.of(frame),
                filled.stream().map(each -> each.shape().getBounds2D()).toList());
        assertTrue(filled.get(0).filled());
        assertEquals(frame, drawn.shapes(Color.RED).get(0).shape().getBounds2D());
        assertEquals(new Vector2(18, 33), symbol);
        assertEquals(List.of(LINES.get(0) + " at 38.0,37.5", LINES.get(1) + " at 38.0,54.5"), drawn.texts());
    }

    @Test
    void aLineIsShortenedOnlyIfItMakesTheBadgeTooWide() {
        double width = BadgePainter.width(context, LINES, SYMBOL_WIDTH);
        assertEquals(LINES, BadgePainter.shortened(context, LINES, SYMBOL_WIDTH, width));
        List<String> shortened = BadgePainter.shortened(context, LINES, SYMBOL_WIDTH, width - 2);
        assertEquals(LINES.get(0), shortened.get(0));
        assertNotEquals(LINES.get(1), shortened.get(1));
        assertTrue(BadgePainter.width(context, shortened, SYMBOL_WIDTH) < width);
    }
}
