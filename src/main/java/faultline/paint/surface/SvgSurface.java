package faultline.paint.surface;

import faultline.geometry.Vector2;
import faultline.io.XmlText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.Ellipse2D;
import java.awt.geom.PathIterator;
import java.util.Locale;

/** A surface that becomes an SVG file. Viewers clip what reaches beyond its edges. */
public final class SvgSurface implements Surface {

    /** The width of a space, in units of the font size. */
    private static final double SPACE_WIDTH = 0.32;

    private final StringBuilder out = new StringBuilder();
    private final String size;

    /** Creates an empty picture; width and height in pixels. */
    public SvgSurface(int width, int height) {
        size = "width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height + '"';
    }

    /** Creates a picture that is filled with a background colour; width and height in pixels. */
    public SvgSurface(int width, int height, Color background) {
        this(width, height);
        String fill = SvgFormat.colourAttributes("fill", background);
        out.append("<rect width=\"" + width + "\" height=\"" + height + "\"" + fill + "/>\n");
    }

    /** Returns the text of the SVG file. */
    public String toSvg() {
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " font-family=\"" + SvgFormat.FONT_FAMILIES
                + "\" stroke-linejoin=\"round\">\n" + out + "</svg>\n";
    }

    /**
     * Returns the picture as an element of an HTML page, in the font of the page.
     *
     * @param cssClass the CSS class of the element
     * @param title the description of the picture for screen readers; empty for a picture that only repeats the text
     *     beside it
     */
    public String toHtml(String cssClass, String title) {
        String start = "<svg class=\"" + cssClass + "\" " + size + " stroke-linejoin=\"round\"";
        return title.isEmpty()
                ? start + " aria-hidden=\"true\">\n" + out + "</svg>"
                : start + " role=\"img\"><title>" + XmlText.escapeAttribute(title) + "</title>\n" + out + "</svg>\n";
    }

    /** Returns the text of the SVG file of a picture that was drawn in the colours of the light theme. */
    public String toSvg(SvgTheme theme) {
        return theme.apply(toSvg());
    }

    @Override
    public void fill(Shape shape, Color colour) {
        boolean evenOdd = shape.getPathIterator(null).getWindingRule() == PathIterator.WIND_EVEN_ODD;
        out.append(startTag(shape) + SvgFormat.colourAttributes("fill", colour)
                + (evenOdd ? " fill-rule=\"evenodd\"" : "") + "/>\n");
    }

    @Override
    public void draw(Shape shape, Color colour, Stroke stroke) {
        if (stroke instanceof BasicStroke line) {
            String attributes = SvgFormat.colourAttributes("stroke", colour) + strokeAttributes(line);
            out.append(startTag(shape) + " fill=\"none\"" + attributes + "/>\n");
        } else {
            fill(stroke.createStrokedShape(shape), colour);
        }
    }

    private static CharSequence startTag(Shape shape) {
        if (shape instanceof Ellipse2D ellipse && ellipse.getWidth() == ellipse.getHeight()) {
            return "<circle cx=\"" + SvgFormat.number(ellipse.getCenterX()) + "\" cy=\""
                    + SvgFormat.number(ellipse.getCenterY()) + "\" r=\"" + SvgFormat.number(ellipse.getWidth() / 2)
                    + '"';
        }
        return pathData(shape.getPathIterator(null)).insert(0, "<path d=\"").append('"');
    }

    @Override
    public void drawText(String text, Vector2 at, TextStyle style) {
        if (Subscripts.split(text).size() > 1 && style.anchor() != TextStyle.Anchor.START) {
            // Some viewers anchor each part of a text with subscripts separately.
            double shift = style.anchor().share() * style.estimateWidth(text.replace("_", ""));
            appendStyledText(
                    text,
                    style.horizontal() ? at.minus(new Vector2(shift, 0)) : at.plus(new Vector2(0, shift)),
                    style.withAnchor(TextStyle.Anchor.START));
        } else {
            appendStyledText(text, at, style);
        }
    }

    private void appendStyledText(String text, Vector2 at, TextStyle style) {
        String rotation =
                " transform=\"rotate(-90 " + SvgFormat.number(at.x()) + " " + SvgFormat.number(at.y()) + ")\"";
        String attributes = " font-size=\"" + SvgFormat.number(style.size()) + "\" text-anchor=\""
                + style.anchor().name().toLowerCase(Locale.ROOT) + '"'
                + (style.bold() ? " font-weight=\"bold\"" : "")
                + (style.horizontal() ? "" : rotation)
                + SvgFormat.colourAttributes("fill", style.colour());
        appendText(at.x(), at.y(), attributes, textSpans(text, style.size()));
    }

    /**
     * Returns the parts of a text, each of which is shifted from the baseline of the part before. A space at the
     * beginning of a part becomes a gap, because some viewers drop it.
     */
    private static String textSpans(String text, double size) {
        StringBuilder spans = new StringBuilder();
        boolean lowered = false;
        for (Subscripts.TextRun run : Subscripts.split(text)) {
            if (run.subscript() == lowered) {
                spans.append(XmlText.escapeAttribute(run.text()));
                continue;
            }
            boolean gap = run.text().startsWith(" ");
            double shift = (run.subscript() ? 1 : -1) * Subscripts.DROP_RATIO * size;
            spans.append("<tspan dy=\"").append(SvgFormat.number(shift)).append('"');
            spans.append(gap ? " dx=\"" + SvgFormat.number(SPACE_WIDTH * size) + '"' : "");
            spans.append(run.subscript() ? " font-size=\"" + SvgFormat.number(Subscripts.SIZE_RATIO * size) + '"' : "");
            spans.append('>').append(XmlText.escapeAttribute(run.text().substring(gap ? 1 : 0)));
            spans.append("</tspan>");
            lowered = run.subscript();
        }
        return spans.toString();
    }

    @Override
    public void drawText(String text, double x, double y, Color colour, Font font) {
        appendText(x, y, fontSize(font) + SvgFormat.colourAttributes("fill", colour), XmlText.escapeAttribute(text));
    }

    @Override
    public void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font) {
        // Many viewers do not know the attribute paint-order, and would paint the halo over the letters.
        String attributes = fontSize(font)
                + SvgFormat.colourAttributes("fill", halo)
                + SvgFormat.colourAttributes("stroke", halo)
                + strokeAttributes(DrawContext.HALO_STROKE)
                + " aria-hidden=\"true\"";
        appendText(x, y, attributes, XmlText.escapeAttribute(text));
        drawText(text, x, y, colour, font);
    }

    private static String fontSize(Font font) {
        return " font-size=\"" + SvgFormat.number(font.getSize2D()) + '"';
    }

    private void appendText(double x, double y, String attributes, String content) {
        String position = "x=\"" + SvgFormat.number(x) + "\" y=\"" + SvgFormat.number(y) + '"';
        out.append("<text " + position + attributes + ">" + content + "</text>\n");
    }

    @Override
    public FontRenderContext fontRenderContext() {
        return DrawContext.FONT_CONTEXT;
    }

    private static StringBuilder strokeAttributes(BasicStroke stroke) {
        StringBuilder line = new StringBuilder(" stroke-width=\"")
                .append(SvgFormat.number(stroke.getLineWidth()))
                .append('"');
        line.append(stroke.getEndCap() == BasicStroke.CAP_ROUND ? " stroke-linecap=\"round\"" : "");
        line.append(stroke.getLineJoin() == BasicStroke.JOIN_MITER ? " stroke-linejoin=\"miter\"" : "");
        if (stroke.getDashArray() != null) {
            line.append(" stroke-dasharray=\"");
            for (float length : stroke.getDashArray()) {
                line.append(SvgFormat.number(length)).append(' ');
            }
            line.setCharAt(line.length() - 1, '"');
        }
        return line;
    }

    private static StringBuilder pathData(PathIterator path) {
        StringBuilder text = new StringBuilder();
        double[] coordinates = new double[6];
        for (; !path.isDone(); path.next()) {
            switch (path.currentSegment(coordinates)) {
                case PathIterator.SEG_MOVETO -> appendSegment(text, 'M', coordinates, 2);
                case PathIterator.SEG_LINETO -> appendSegment(text, 'L', coordinates, 2);
                case PathIterator.SEG_QUADTO -> appendSegment(text, 'Q', coordinates, 4);
                case PathIterator.SEG_CUBICTO -> appendSegment(text, 'C', coordinates, 6);
                default -> text.append('Z');
            }
        }
        return text;
    }

    private static void appendSegment(StringBuilder text, char letter, double[] coordinates, int count) {
        text.append(letter);
        for (int i = 0; i < count; i++) {
            text.append(i == 0 ? "" : " ").append(SvgFormat.number(coordinates[i]));
        }
    }
}
