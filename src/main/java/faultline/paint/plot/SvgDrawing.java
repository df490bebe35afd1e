package faultline.paint.plot;

import faultline.geometry.Vec;
import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A drawing that becomes an SVG file. */
public final class SvgDrawing implements Drawing {

    /** How wide a space is, as a share of the size of the letters. */
    private static final double SPACE = 0.32;

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
        if (Subscripts.runs(text).size() > 1 && style.anchor() != TextStyle.Anchor.START) {
            // Not every viewer anchors a text of several stretches as a whole.
            double shift = style.width(text.replace("_", "")) * style.anchor().ordinal() / 2;
            line(text, style.upright() ? at.minus(new Vec(shift, 0)) : at.plus(new Vec(0, shift)), style.anchored(TextStyle.Anchor.START));
        } else {
            line(text, at, style);
        }
    }

    private void line(String text, Vec at, TextStyle style) {
        out.append("<text x=\"").append(SvgText.number(at.x())).append("\" y=\"").append(SvgText.number(at.y())).append("\" font-size=\"")
                .append(SvgText.number(style.size())).append("\" text-anchor=\"").append(style.anchor().name().toLowerCase(Locale.ROOT)).append('"')
                .append(style.bold() ? " font-weight=\"bold\"" : "")
                .append(style.upright() ? "" : " transform=\"rotate(-90 " + SvgText.number(at.x()) + " " + SvgText.number(at.y()) + ")\"")
                .append(SvgText.paint("fill", style.colour())).append('>').append(runs(text, style.size())).append("</text>\n");
    }

    /**
     * The picture so far as a file.
     *
     * @param appearance of the picture, which was drawn in the light theme's colours
     * @return the text of an SVG file
     */
    public String toFile(Appearance appearance) {
        return appearance.of(out + "</svg>\n");
    }

    private static String circle(Vec centre, double radius) {
        return "<circle cx=\"" + SvgText.number(centre.x()) + "\" cy=\"" + SvgText.number(centre.y()) + "\" r=\"" + SvgText.number(radius) + "\"";
    }

    private static String path(List<Vec> points, boolean closed) {
        return points.stream().map(point -> SvgText.number(point.x()) + " "
                + SvgText.number(point.y())).collect(Collectors.joining("L", "M", closed ? "Z" : ""));
    }

    private static String pen(Pen pen) {
        String dashes = pen.dash().lengths().stream().map(SvgText::number).collect(Collectors.joining(" "));
        return SvgText.paint("stroke", pen.colour()) + " stroke-width=\"" + SvgText.number(pen.width()) + "\""
                + (dashes.isEmpty() ? " stroke-linecap=\"round\"" : " stroke-dasharray=\"" + dashes + "\"");
    }

    /**
     * The stretches of a text; each is set off from where the one before it left the line. A space at a stretch's beginning is a gap: not every
     * viewer keeps it otherwise.
     */
    private static String runs(String text, double size) {
        StringBuilder spans = new StringBuilder();
        boolean lowered = false;
        for (Subscripts.Run run : Subscripts.runs(text)) {
            String shift = run.lowered() == lowered ? "" : " dy=\"" + SvgText.number((run.lowered() ? 1 : -1) * Subscripts.DROP * size) + "\"";
            String small = run.lowered() ? " font-size=\"" + SvgText.number(Subscripts.SIZE * size) + "\"" : "";
            String gap = run.text().startsWith(" ") && !shift.isEmpty() ? " dx=\"" + SvgText.number(SPACE * size) + "\"" : "";
            String words = SvgText.escaped(gap.isEmpty() ? run.text() : run.text().substring(1));
            spans.append(shift.isEmpty() ? words : "<tspan" + shift + gap + small + ">" + words + "</tspan>");
            lowered = run.lowered();
        }
        return spans.toString();
    }
}
