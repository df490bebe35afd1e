package faultline.paint;

import faultline.paint.plot.SvgText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.PathIterator;

/** A picture of lines and letters that becomes an SVG file. What reaches beyond its edge is cut off by whoever shows it. */
final class SvgSurface implements Surface {

    private static final FontRenderContext FONTS = new FontRenderContext(null, true, true);

    private final StringBuilder out = new StringBuilder();

    SvgSurface(int width, int height) {
        out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").append(width).append("\" height=\"").append(height)
                .append("\" viewBox=\"0 0 ").append(width).append(' ').append(height).append("\" font-family=\"").append(SvgText.FONTS)
                .append("\" font-size=\"").append(Brush.FONT.getSize()).append("\">\n");
    }

    /** The picture so far as the text of a file. */
    String toFile() {
        return out + "</svg>\n";
    }

    @Override
    public void fill(Shape shape, Color colour) {
        PathIterator path = shape.getPathIterator(null);
        String rule = path.getWindingRule() == PathIterator.WIND_EVEN_ODD ? " fill-rule=\"evenodd\"" : "";
        out.append("<path d=\"").append(path(path)).append('"').append(SvgText.paint("fill", colour)).append(rule).append("/>\n");
    }

    @Override
    public void draw(Shape shape, Color colour, Stroke stroke) {
        if (stroke instanceof BasicStroke line) {
            out.append("<path d=\"").append(path(shape.getPathIterator(null))).append("\" fill=\"none\"").append(SvgText.paint("stroke", colour))
                    .append(line(line)).append("/>\n");
        } else {
            fill(stroke.createStrokedShape(shape), colour);
        }
    }

    @Override
    public void text(String text, double x, double y, Color colour, Font font) {
        write(text, x, y, size(font) + SvgText.paint("fill", colour));
    }

    @Override
    public void haloedText(String text, double x, double y, Color colour, Color halo, Font font) {
        write(text, x, y, size(font) + SvgText.paint("fill", colour) + SvgText.paint("stroke", halo) + line((BasicStroke) Brush.HALO) + " paint-order=\"stroke\"");
    }

    private static String size(Font font) {
        return font.getSize() == Brush.FONT.getSize() ? "" : " font-size=\"" + font.getSize() + '"';
    }

    private void write(String text, double x, double y, String attributes) {
        out.append("<text x=\"").append(SvgText.number(x)).append("\" y=\"").append(SvgText.number(y)).append('"').append(attributes).append('>')
                .append(SvgText.escaped(text)).append("</text>\n");
    }

    @Override
    public FontRenderContext fonts() {
        return FONTS;
    }

    private static StringBuilder line(BasicStroke stroke) {
        StringBuilder line = new StringBuilder(" stroke-width=\"").append(SvgText.number(stroke.getLineWidth())).append('"');
        line.append(stroke.getEndCap() == BasicStroke.CAP_ROUND ? " stroke-linecap=\"round\"" : "");
        line.append(stroke.getLineJoin() == BasicStroke.JOIN_ROUND ? " stroke-linejoin=\"round\"" : "");
        if (stroke.getDashArray() != null) {
            line.append(" stroke-dasharray=\"");
            for (float length : stroke.getDashArray()) {
                line.append(SvgText.number(length)).append(' ');
            }
            line.setCharAt(line.length() - 1, '"');
        }
        return line;
    }

    private static StringBuilder path(PathIterator path) {
        StringBuilder text = new StringBuilder();
        double[] places = new double[6];
        for (; !path.isDone(); path.next()) {
            switch (path.currentSegment(places)) {
                case PathIterator.SEG_MOVETO -> step(text, 'M', places, 2);
                case PathIterator.SEG_LINETO -> step(text, 'L', places, 2);
                case PathIterator.SEG_QUADTO -> step(text, 'Q', places, 4);
                case PathIterator.SEG_CUBICTO -> step(text, 'C', places, 6);
                default -> text.append('Z');
            }
        }
        return text;
    }

    private static void step(StringBuilder text, char letter, double[] places, int count) {
        text.append(letter);
        for (int i = 0; i < count; i++) {
            text.append(i == 0 ? "" : " ").append(SvgText.number(places[i]));
        }
    }
}
