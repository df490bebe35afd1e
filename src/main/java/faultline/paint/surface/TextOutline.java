package faultline.paint.surface;

import java.awt.Font;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;

/** The outlines of texts in any script: letters that join, and texts from right to left, need a layout. */
final class TextOutline {

    private TextOutline() {}

    /** Returns the outline of a text; x and y are those of the start of its baseline. */
    static Shape of(String text, Font font, FontRenderContext context, double x, double y) {
        return needsLayout(text)
                ? new TextLayout(text, font, context).getOutline(AffineTransform.getTranslateInstance(x, y))
                : font.createGlyphVector(context, text).getOutline((float) x, (float) y);
    }

    /** Returns the bounds of the outline of a text whose baseline starts at the origin. */
    static Rectangle2D bounds(String text, Font font, FontRenderContext context) {
        return needsLayout(text)
                ? of(text, font, context, 0, 0).getBounds2D()
                : font.createGlyphVector(context, text).getVisualBounds();
    }

    /** Returns whether letters join, combine or run leftwards; the layout of other texts would be slower. */
    private static boolean needsLayout(String text) {
        return Font.textRequiresLayout(text.toCharArray(), 0, text.length());
    }
}
