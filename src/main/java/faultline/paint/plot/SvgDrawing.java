package faultline.paint.plot;

import faultline.geometry.Vec;
import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A drawing that becomes an SVG file. Places are written to a hundredth of a pixel, so that the bytes hang on nothing but the picture. */
public final class SvgDrawing implements Drawing {

    private static final String FONTS = "DejaVu Sans, Verdana, Arial, sans-serif";

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
                .append("\" viewBox=\"0 0 ").append(width).append(' ').append(height).append("\" font-family=\"").append(FONTS)
                .append("\" stroke-linejoin=\"round\">\n<rect width=\"").append(width).append("\" height=\"").append(height).append('"')
                .append(paint("fill", ground)).append("/>\n");
    }

    @Override
    public void stroke(List<Vec> points, boolean closed, Pen pen) {
        if (points.size() > 1) {
            out.append("<path d=\"").append(path(points, closed)).append("\" fill=\"none\"").append(pen(pen)).append("/>\n");
        }
    }

    @Override
    public void fill(List<Vec> points, Color colour) {
        out.append("<path d=\"").append(path(points, true)).append('"').append(paint("fill", colour)).append("/>\n");
    }

    @Override
    public void ring(Vec centre, double radius, Pen pen) {
        out.append(circle(centre, radius)).append(" fill=\"none\"").append(pen(pen)).append("/>\n");
    }

    @Override
    public void disc(Vec centre, double radius, Color colour) {
        out.append(circle(centre, radius)).append(paint("fill", colour)).append("/>\n");
    }

    @Override
    public void text(String text, Vec at, TextStyle style) {
        out.append("<text x=\"").append(number(at.x())).append("\" y=\"").append(number(at.y())).append("\" font-size=\"")
                .append(number(style.size())).append("\" text-anchor=\"").append(style.anchor().name().toLowerCase(Locale.ROOT)).append('"')
                .append(style.bold() ? " font-weight=\"bold\"" : "")
                .append(style.upright() ? "" : " transform=\"rotate(-90 " + number(at.x()) + " " + number(at.y()) + ")\"")
                .append(paint("fill", style.colour())).append('>').append(escaped(text)).append("</text>\n");
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
        return "<circle cx=\"" + number(centre.x()) + "\" cy=\"" + number(centre.y()) + "\" r=\"" + number(radius) + "\"";
    }

    private static String path(List<Vec> points, boolean closed) {
        return points.stream().map(point -> number(point.x()) + " " + number(point.y())).collect(Collectors.joining("L", "M", closed ? "Z" : ""));
    }

    private static String pen(Pen pen) {
        String dashes = pen.dash().lengths().stream().map(SvgDrawing::number).collect(Collectors.joining(" "));
        return paint("stroke", pen.colour()) + " stroke-width=\"" + number(pen.width()) + "\""
                + (dashes.isEmpty() ? " stroke-linecap=\"round\"" : " stroke-dasharray=\"" + dashes + "\"");
    }

    private static String paint(String attribute, Color colour) {
        String solid = String.format(Locale.ROOT, " %s=\"#%06x\"", attribute, colour.getRGB() & 0xFFFFFF);
        return colour.getAlpha() == 255 ? solid : solid + " " + attribute + "-opacity=\"" + number(colour.getAlpha() / 255.0) + "\"";
    }

    /** At most two decimals, no zeros at the end, and no sign on a zero. */
    static String number(double value) {
        long hundredths = Math.round(value * 100);
        long rest = Math.abs(hundredths % 100);
        String sign = hundredths < 0 ? "-" : "";
        String decimals = rest == 0 ? "" : rest % 10 == 0 ? "." + rest / 10 : (rest < 10 ? ".0" : ".") + rest;
        return sign + Math.abs(hundredths / 100) + decimals;
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
