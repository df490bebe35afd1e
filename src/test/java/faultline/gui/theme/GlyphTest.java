package faultline.gui.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class GlyphTest {

    private static final int MARGIN = 4;

    @ParameterizedTest
    @EnumSource(Glyph.class)
    void everyGlyphIsPaintedWithinItsSquare(Glyph glyph) {
        BufferedImage image =
                new BufferedImage(Glyph.SIZE + 2 * MARGIN, Glyph.SIZE + 2 * MARGIN, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        glyph.paint(graphics, MARGIN, MARGIN, Glyph.SIZE, Color.BLACK);
        graphics.dispose();
        int inside = 0;
        for (int x = 0; x < image.getWidth(); x++) {
            for (int y = 0; y < image.getHeight(); y++) {
                boolean painted = image.getRGB(x, y) >>> 24 > 100;
                boolean within = Math.min(x, y) >= MARGIN && Math.max(x, y) < MARGIN + Glyph.SIZE;
                assertTrue(within || !painted, glyph + " paints beyond its square at " + x + ", " + y);
                inside += painted ? 1 : 0;
            }
        }
        assertTrue(inside > 20, glyph + " paints " + inside + " pixels only");
    }

    @Test
    void aGlyphIsParsedCommandByCommand() {
        assertEquals(
                new Rectangle2D.Double(1, 2, 3, 4),
                Glyph.Parser.parse("M 1 2 L 4 2 L 4 6 Z").getBounds2D());
        assertEquals(
                new Rectangle2D.Double(3, 3, 4, 4),
                Glyph.Parser.parse("O 5 5 2").getBounds2D());
        assertThrows(IllegalArgumentException.class, () -> Glyph.Parser.parse("Q 1 2"));
    }
}
