package faultline.paint.plot;

import faultline.geometry.Vec;
import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A drawing that becomes an SVG file. */
public final class SvgDrawing implements Drawing {

    private final StringBuilder out = new StringBuilder();

    /**
     * An empty picture.
     *
     * @param width pixels
     * @param height pixels
     * @param ground what it is painted on
     */
    public SvgDrawing(int width, int height, Color ground) {
        out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").append(width).append("\" height=\"").append(height)
                .append("\" viewBox=\"0 0 ").append(width).append(' ').append(height).append("\" font-family=\"").append(SvgText.FONTS)
                .append("\" stroke-linejoin=\"round\">\n<rect width=\"").append(width).append("\" height=\"").append(height).append('"')
                .append(SvgText.paint("fill", ground)).append("/>\n");
    }

    @Override
    public void stroke(List<Vec> points, boolean closed, Pen pen) {
        if (points.size() > 1) {
            out.append("<path d=\"").append(path(points, closed)).append("\" fill=\"none\"").append(pen(pen)).append("/>\n");
        }
    }

    @Override
    public void fill(List<Vec> points, Color colour) {
        out.append("<path d=\"").append(path(points, true)).append('"').append(SvgText.paint("fill", colour)).append("/>\n");
    }

    @Override
    public void ring(Vec centre, double radius, Pen pen) {
        out.append(circle(centre, radius)).append(" fill=\"none\"").append(pen(pen)).append("/>\n");
    }

    @Override
    public void disc(Vec centre, double radius, Color colour) {
        out.append(circle(centre, radius)).append(SvgText.paint("fill", colour)).append("/>\n");
    }

    @Override
    public void text(String text, Vec at, TextStyle style) {
        out.append("<text x=\"").append(SvgText.number(at.x())).append("\" y=\"").append(SvgText.number(at.y())).append("\" font-size=\"")
                .append(SvgText.number(style.size())).append("\" text-anchor=\"").append(style.anchor().name().toLowerCase(Locale.ROOT)).append('"')
                .append(style.bold() ? " font-weight=\"bold\"" : "")
                .append(style.upright() ? "" : " transform=\"rotate(-90 " + SvgText.number(at.x()) + " " + SvgText.number(at.y()) + ")\"")
                .append(SvgText.paint("fill", style.colour())).append('>').append(SvgText.escaped(text)).append("</text>\n");
    }

    /**
     * The picture so far as a file.
     *
     * @return the text of an SVG file
     */
    public String toFile() {
        return out + "</svg>\n";
    }

    private static String circle(Vec centre, double radius) {
        return "<circle cx=\"" + SvgText.number(centre.x()) + "\" cy=\"" + SvgText.number(centre.y()) + "\" r=\"" + SvgText.number(radius) + "\"";
    }

    private static String path(List<Vec> points, boolean closed) {
        return points.stream().map(point -> SvgText.number(point.x()) + " " + SvgText.number(point.y())).collect(Collectors.joining("L", "M", closed ? "Z" : ""));
    }

    private static String pen(Pen pen) {
        String dashes = pen.dash().lengths().stream().map(SvgText::number).collect(Collectors.joining(" "));
        return SvgText.paint("stroke", pen.colour()) + " stroke-width=\"" + SvgText.number(pen.width()) + "\""
                + (dashes.isEmpty() ? " stroke-linecap=\"round\"" : " stroke-dasharray=\"" + dashes + "\"");
    }
}
