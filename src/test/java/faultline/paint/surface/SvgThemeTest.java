package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.awt.Color;
import java.io.StringReader;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.xml.sax.InputSource;

/** One picture on white, on a dark background, and on the background that the user prefers. */
class SvgThemeTest {

    private static SvgSurface picture() {
        ChartStyle theme = ChartStyle.LIGHT;
        SvgSurface surface = new SvgSurface(200, 100, theme.palette().canvas());
        surface.drawText(
                "text", new Vector2(10, 10), TextStyle.plain(12, theme.palette().text()));
        surface.fill(
                Shapes.polygon(List.of(new Vector2(1, 1), new Vector2(9, 1), new Vector2(9, 9))),
                ChartStyle.withOpacity(theme.series().get(1), 0.2));
        surface.draw(
                Shapes.circle(new Vector2(5, 5), 3),
                LineStyle.solid(theme.series().get(0), 1));
        return surface;
    }

    @Test
    void everyColourIsReplacedByThatOfTheDarkTheme() {
        String dark = picture().toSvg(SvgTheme.DARK);
        assertTrue(
                dark.contains(
                        "fill=\"" + Palette.toHex(ChartStyle.DARK.palette().canvas()) + "\""),
                dark);
        assertTrue(
                dark.contains(
                        "fill=\"" + Palette.toHex(ChartStyle.DARK.palette().text()) + "\""),
                dark);
        assertTrue(
                dark.contains(
                        "stroke=\"" + Palette.toHex(ChartStyle.DARK.series().get(0)) + "\""),
                dark);
        assertTrue(
                dark.contains("fill=\"" + Palette.toHex(ChartStyle.DARK.series().get(1)) + "\" fill-opacity"), dark);
        assertFalse(dark.contains(Palette.toHex(ChartStyle.LIGHT.palette().text())), dark);
    }

    @Test
    void anAdaptivePictureIsTheLightOneWithARuleForEachColour() throws Exception {
        String adaptive = picture().toSvg(SvgTheme.ADAPTIVE);
        assertEquals(picture().toSvg(SvgTheme.LIGHT), adaptive.replaceFirst("(?s)<style>.*</style>\n", ""));
        assertTrue(
                adaptive.contains(
                        "[stroke=\"" + Palette.toHex(ChartStyle.LIGHT.series().get(0)) + "\"] {stroke: "
                                + Palette.toHex(ChartStyle.DARK.series().get(0)) + "}"),
                adaptive);
        assertEquals(
                1,
                DocumentBuilderFactory.newDefaultInstance()
                        .newDocumentBuilder()
                        .parse(new InputSource(new StringReader(adaptive)))
                        .getElementsByTagName("style")
                        .getLength());
    }

    @Test
    void aColourOutsideTheThemeIsRejected() {
        SvgSurface surface = new SvgSurface(10, 10, new Color(0x123456));
        assertThrows(IllegalStateException.class, () -> surface.toSvg(SvgTheme.DARK));
    }
}
