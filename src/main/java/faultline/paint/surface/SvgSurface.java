package faultline.paint.surface;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.PathIterator;

/**
 * A picture of lines and letters that becomes an SVG file. What reaches beyond its edge is cut off by whoever shows it.
 */
public final class SvgSurface implements Surface {

    private static final FontRenderContext FONT_CONTEXT = new FontRenderContext(null, true, true);

    private final StringBuilder out = new StringBuilder();

    public SvgSurface(int width, int height) {
        out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"")
                .append(width)
                .append("\" height=\"")
                .append(height)
                .append("\" viewBox=\"0 0 ")
                .append(width)
                .append(' ')
                .append(height)
                .append("\" font-family=\"")
                .append(SvgFormat.FONT_FAMILIES)
                .append("\" font-size=\"")
                .append(DrawContext.DEFAULT_FONT.getSize())
                .append("\">\n");
    }

    /** The picture so far as the text of a file. */
    public String toSvg() {
        return out + "</svg>\n";
    }

    @Override
    public void fill(Shape shape, Color colour) {
        PathIterator path = shape.getPathIterator(null);
        String rule = path.getWindingRule() == PathIterator.WIND_EVEN_ODD ? " fill-rule=\"evenodd\"" : "";
        out.append("<path d=\"")
                .append(pathData(path))
                .append('"')
                .append(SvgFormat.colourAttributes("fill", colour))
                .append(rule)
                .append("/>\n");
    }

    @Override
    public void draw(Shape shape, Color colour, Stroke stroke) {
        if (stroke instanceof BasicStroke line) {
            out.append("<path d=\"")
                    .append(pathData(shape.getPathIterator(null)))
                    .append("\" fill=\"none\"")
                    .append(SvgFormat.colourAttributes("stroke", colour))
                    .append(strokeAttributes(line))
                    .append("/>\n");
        } else {
            fill(stroke.createStrokedShape(shape), colour);
        }
    }

    @Override
    public void drawText(String text, double x, double y, Color colour, Font font) {
        appendText(text, x, y, fontSizeAttribute(font) + SvgFormat.colourAttributes("fill", colour));
    }

    @Override
    public void drawHaloedText(String text, double x, double y, Color colour, Color halo, Font font) {
        appendText(
                text,
                x,
                y,
                fontSizeAttribute(font) + SvgFormat.colourAttributes("fill", colour)
                        + SvgFormat.colourAttributes("stroke", halo)
                        + strokeAttributes((BasicStroke) DrawContext.HALO_STROKE) + " paint-order=\"stroke\"");
    }

    private static String fontSizeAttribute(Font font) {
        return font.getSize() == DrawContext.DEFAULT_FONT.getSize() ? "" : " font-size=\"" + font.getSize() + '"';
    }

    private void appendText(String text, double x, double y, String attributes) {
        out.append("<text x=\"")
                .append(SvgFormat.number(x))
                .append("\" y=\"")
                .append(SvgFormat.number(y))
                .append('"')
                .append(attributes)
                .append('>')
                .append(SvgFormat.escape(text))
                .append("</text>\n");
    }

    @Override
    public FontRenderContext fontRenderContext() {
        return FONT_CONTEXT;
    }

    private static StringBuilder strokeAttributes(BasicStroke stroke) {
        StringBuilder line = new StringBuilder(" stroke-width=\"")
                .append(SvgFormat.number(stroke.getLineWidth()))
                .append('"');
        line.append(stroke.getEndCap() == BasicStroke.CAP_ROUND ? " stroke-linecap=\"round\"" : "");
        line.append(stroke.getLineJoin() == BasicStroke.JOIN_ROUND ? " stroke-linejoin=\"round\"" : "");
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
        double[] places = new double[6];
        for (; !path.isDone(); path.next()) {
            switch (path.currentSegment(places)) {
                case PathIterator.SEG_MOVETO -> appendSegment(text, 'M', places, 2);
                case PathIterator.SEG_LINETO -> appendSegment(text, 'L', places, 2);
                case PathIterator.SEG_QUADTO -> appendSegment(text, 'Q', places, 4);
                case PathIterator.SEG_CUBICTO -> appendSegment(text, 'C', places, 6);
                default -> text.append('Z');
            }
        }
        return text;
    }

    private static void appendSegment(StringBuilder text, char letter, double[] places, int count) {
        text.append(letter);
        for (int i = 0; i < count; i++) {
            text.append(i == 0 ? "" : " ").append(SvgFormat.number(places[i]));
        }
    }
}
