package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Font;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.Area;
import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.Test;

/** Texts with a halo, such as the names of obstacles on the canvas. */
class TextOutlineTest {

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 24);
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    /** Yod is a small letter at the top of the line. */
    private static final String YOD_ALEF = "\u05D9\u05D0";

    private static final String ALEF_YOD = "\u05D0\u05D9";

    private static Shape outline(String text) {
        return TextOutline.of(text, FONT, CONTEXT, 10, 20);
    }

    private static Shape inOrderOfReading(String text) {
        return FONT.createGlyphVector(CONTEXT, text).getOutline(10, 20);
    }

    /** The left half of a shape. */
    private static Rectangle2D left(Shape shape) {
        Rectangle2D all = shape.getBounds2D();
        Area half = new Area(shape);
        half.intersect(new Area(new Rectangle2D.Double(all.getX(), all.getY(), all.getWidth() / 4, all.getHeight())));
        return half.getBounds2D();
    }

    @Test
    void aTextFromRightToLeftBeginsAtTheRight() {
        assumeTrue(FONT.canDisplayUpTo(ALEF_YOD) < 0, "there is no font with Hebrew letters");
        assertEquals(
                left(inOrderOfReading(ALEF_YOD)).getHeight(),
                left(outline(YOD_ALEF)).getHeight(),
                0.5,
                "its last letter is at the left");
        assertNotEquals(
                left(outline(YOD_ALEF)).getHeight(), left(outline(ALEF_YOD)).getHeight(), 2);
    }

    @Test
    void anEmptyTextHasAnEmptyOutline() {
        assertEquals(0, outline("").getBounds2D().getWidth());
    }
}
