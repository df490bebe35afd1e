package faultline.paint.surface;

import faultline.geometry.Vector2;
import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A drawing that becomes an SVG file. */
public final class SvgDrawing implements Drawing {

    /** How wide a space is, as a share of the size of the letters. */
    private static final double SPACE_WIDTH = 0.32;

    private final StringBuilder out = new StringBuilder();

    /**
     * An empty picture.
     *
     * @param width pixels
     * @param height pixels
     * @param ground what it is painted on
     */
    public SvgDrawing(int width, int height, Color ground) {
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
                .append("\" stroke-linejoin=\"round\">\n<rect width=\"")
                .append(width)
                .append("\" height=\"")
                .append(height)
                .append('"')
                .append(SvgFormat.colourAttributes("fill", ground))
                .append("/>\n");
    }

    @Override
    public void drawPolyline(List<Vector2> points, boolean closed, LineStyle pen) {
        if (points.size() > 1) {
            out.append("<path d=\"")
                    .append(pathData(points, closed))
                    .append("\" fill=\"none\"")
                    .append(strokeAttributes(pen))
                    .append("/>\n");
        }
    }

    @Override
    public void fillPolygon(List<Vector2> points, Color colour) {
        out.append("<path d=\"")
                .append(pathData(points, true))
                .append('"')
                .append(SvgFormat.colourAttributes("fill", colour))
                .append("/>\n");
    }

    @Override
    public void drawCircle(Vector2 centre, double radius, LineStyle pen) {
        out.append(circleStart(centre, radius))
                .append(" fill=\"none\"")
                .append(strokeAttributes(pen))
                .append("/>\n");
    }

    @Override
    public void fillCircle(Vector2 centre, double radius, Color colour) {
        out.append(circleStart(centre, radius))
                .append(SvgFormat.colourAttributes("fill", colour))
                .append("/>\n");
    }

    @Override
    public void drawText(String text, Vector2 at, TextStyle style) {
        if (Subscripts.split(text).size() > 1 && style.anchor() != TextStyle.Anchor.START) {
            // Not every viewer anchors a text of several stretches as a whole.
            double shift =
                    style.estimateWidth(text.replace("_", "")) * style.anchor().ordinal() / 2;
            writeText(
                    text,
                    style.horizontal() ? at.minus(new Vector2(shift, 0)) : at.plus(new Vector2(0, shift)),
                    style.withAnchor(TextStyle.Anchor.START));
        } else {
            writeText(text, at, style);
        }
    }

    private void writeText(String text, Vector2 at, TextStyle style) {
        out.append("<text x=\"")
                .append(SvgFormat.number(at.x()))
                .append("\" y=\"")
                .append(SvgFormat.number(at.y()))
                .append("\" font-size=\"")
                .append(SvgFormat.number(style.size()))
                .append("\" text-anchor=\"")
                .append(style.anchor().name().toLowerCase(Locale.ROOT))
                .append('"')
                .append(style.bold() ? " font-weight=\"bold\"" : "")
                .append(
                        style.horizontal()
                                ? ""
                                : " transform=\"rotate(-90 " + SvgFormat.number(at.x()) + " " + SvgFormat.number(at.y())
                                        + ")\"")
                .append(SvgFormat.colourAttributes("fill", style.colour()))
                .append('>')
                .append(textSpans(text, style.size()))
                .append("</text>\n");
    }

    /**
     * The picture so far as a file.
     *
     * @param appearance of the picture, which was drawn in the light theme's colours
     * @return the text of an SVG file
     */
    public String toSvg(SvgTheme appearance) {
        return appearance.apply(out + "</svg>\n");
    }

    private static String circleStart(Vector2 centre, double radius) {
        return "<circle cx=\"" + SvgFormat.number(centre.x()) + "\" cy=\"" + SvgFormat.number(centre.y()) + "\" r=\""
                + SvgFormat.number(radius) + "\"";
    }

    private static String pathData(List<Vector2> points, boolean closed) {
        return points.stream()
                .map(point -> SvgFormat.number(point.x()) + " " + SvgFormat.number(point.y()))
                .collect(Collectors.joining("L", "M", closed ? "Z" : ""));
    }

    private static String strokeAttributes(LineStyle pen) {
        String dashes = pen.dash().lengths().stream().map(SvgFormat::number).collect(Collectors.joining(" "));
        return SvgFormat.colourAttributes("stroke", pen.colour()) + " stroke-width=\"" + SvgFormat.number(pen.width())
                + "\"" + (dashes.isEmpty() ? " stroke-linecap=\"round\"" : " stroke-dasharray=\"" + dashes + "\"");
    }

    /**
     * The stretches of a text; each is set off from where the one before it left the line. A space at a stretch's
     * beginning is a gap: not every viewer keeps it otherwise.
     */
    private static String textSpans(String text, double size) {
        StringBuilder spans = new StringBuilder();
        boolean lowered = false;
        for (Subscripts.TextRun run : Subscripts.split(text)) {
            String shift = run.subscript() == lowered
                    ? ""
                    : " dy=\"" + SvgFormat.number((run.subscript() ? 1 : -1) * Subscripts.DROP_RATIO * size) + "\"";
            String small =
                    run.subscript() ? " font-size=\"" + SvgFormat.number(Subscripts.SIZE_RATIO * size) + "\"" : "";
            String gap = run.text().startsWith(" ") && !shift.isEmpty()
                    ? " dx=\"" + SvgFormat.number(SPACE_WIDTH * size) + "\""
                    : "";
            String words =
                    SvgFormat.escape(gap.isEmpty() ? run.text() : run.text().substring(1));
            spans.append(shift.isEmpty() ? words : "<tspan" + shift + gap + small + ">" + words + "</tspan>");
            lowered = run.subscript();
        }
        return spans.toString();
    }
}
