package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is drawn, as elements of an SVG file. */
class SvgSurfaceTest {

    private static final TextStyle TEXT = TextStyle.plain(10, Color.BLACK);

    /** Returns the elements of a picture. */
    private static String elements(Consumer<Surface> paint) {
        SvgSurface surface = new SvgSurface(20, 10);
        paint.accept(surface);
        return surface.toSvg()
                .replaceFirst("<svg [^>]*>\n", "")
                .replaceFirst("</svg>\n$", "")
                .strip();
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.004, 0",
        "-0.01, -0.01",
        "0.05, 0.05",
        "0.1, 0.1",
        "0.11, 0.11",
        "-1.5, -1.5",
        "12.345, 12.35",
        "100, 100"
    })
    void aNumberHasAtMostTwoDecimalsAndNoSignOnZero(double value, String text) {
        assertEquals(text, SvgFormat.number(value));
    }

    @Test
    void onlyATranslucentColourHasAnOpacity() {
        assertEquals(" fill=\"#123456\"", SvgFormat.colourAttributes("fill", new Color(0x123456)));
        assertEquals(
                " stroke=\"#123456\" stroke-opacity=\"0.2\"",
                SvgFormat.colourAttributes("stroke", new Color(0x12, 0x34, 0x56, 51)));
    }

    /** Many viewers do not know paint-order, so the order of the elements must be that of the painting. */
    @Test
    void aHaloIsATextOfItsOwnBelowTheLetters() {
        Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 10);
        String[] lines = elements(surface -> surface.drawHaloedText("a<b", 1, 2, Color.BLACK, Color.WHITE, font))
                .split("\n");
        assertEquals(2, lines.length);
        assertTrue(lines[0].matches("<text x=\"1\" y=\"2\".* stroke=\"#ffffff\" .*>a&lt;b</text>"), lines[0]);
        assertEquals("<text x=\"1\" y=\"2\" font-size=\"10\" fill=\"#000000\">a&lt;b</text>", lines[1]);
    }

    @Test
    void aCircleHasItsCentreAndRadius() {
        assertEquals(
                "<circle cx=\"5\" cy=\"4\" r=\"3\" fill=\"#000000\"/>",
                elements(surface -> surface.fill(Shapes.circle(new Vector2(5, 4), 3), Color.BLACK)));
    }

    @Test
    void aShapeKeepsItsCurvesAndItsFillRule() {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        path.moveTo(0, 0);
        path.quadTo(1, 1, 2, 0);
        path.curveTo(3, 1, 4, -1, 5, 0);
        path.closePath();
        String start = "<path d=\"M0 0Q1 1 2 0C3 1 4 -1 5 0Z\" fill=\"#000000\"";
        assertEquals(start + " fill-rule=\"evenodd\"/>", elements(surface -> surface.fill(path, Color.BLACK)));
        path.setWindingRule(Path2D.WIND_NON_ZERO);
        assertEquals(start + "/>", elements(surface -> surface.fill(path, Color.BLACK)));
    }

    @Test
    void aLineHasTheCapJoinAndDashesOfItsStroke() {
        Line2D line = new Line2D.Double(1, 2, 3, 4);
        String start = "<path d=\"M1 2L3 4\" fill=\"none\" stroke=\"#000000\" stroke-width=\"2\"";
        BasicStroke plain = new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);
        assertEquals(start + "/>", elements(surface -> surface.draw(line, Color.BLACK, plain)));
        BasicStroke dashed =
                new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_MITER, 10, new float[] {4, 2.5f}, 0);
        assertEquals(
                start + " stroke-linecap=\"round\" stroke-linejoin=\"miter\" stroke-dasharray=\"4 2.5\"/>",
                elements(surface -> surface.draw(line, Color.BLACK, dashed)));
    }

    @Test
    void aLineWithAnotherStrokeIsFilled() {
        assertEquals(
                "<path d=\"M1 2L3 2L3 4L1 4L1 2Z\" fill=\"#000000\"/>",
                elements(surface -> surface.draw(new Rectangle2D.Double(1, 2, 2, 2), Color.BLACK, shape -> shape)));
    }

    @Test
    void aTextIsAnchoredByTheViewer() {
        assertEquals(
                "<text x=\"12\" y=\"5\" font-size=\"10\" text-anchor=\"end\" fill=\"#000000\">d</text>",
                elements(surface -> surface.drawText("d", new Vector2(12, 5), TEXT.withAnchor(TextStyle.Anchor.END))));
    }

    /** The estimated width is 6.2 for each letter. */
    @ParameterizedTest
    @CsvSource({"START, 50", "MIDDLE, 43.8", "END, 37.6"})
    void aTextWithASubscriptBeginsWhereItsEstimatedWidthPutsIt(TextStyle.Anchor anchor, String start) {
        Vector2 at = new Vector2(50, 50);
        String along = elements(surface -> surface.drawText("d_p", at, TEXT.withAnchor(anchor)));
        assertTrue(along.startsWith("<text x=\"" + start + "\" y=\"50\""), along);
        assertTrue(along.contains("text-anchor=\"start\""), along);
        assertFalse(along.contains("rotate"), along);
        String up = elements(
                surface -> surface.drawText("d_p", at, TEXT.withAnchor(anchor).rotated()));
        String y = SvgFormat.number(100 - Double.parseDouble(start));
        assertTrue(up.startsWith("<text x=\"50\" y=\"" + y + "\""), up);
        assertTrue(up.contains("rotate(-90 50 " + y + ")"), up);
    }
}
