package faultline.paint.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vec;
import java.awt.Color;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.xml.sax.InputSource;

/** One drawing on white, on a dark ground, and on whichever the reader has. */
class AppearanceTest {

    private static SvgDrawing drawing() {
        Theme theme = Theme.LIGHT;
        SvgDrawing drawing = new SvgDrawing(200, 100, theme.palette().canvas());
        drawing.text("text", new Vec(10, 10), TextStyle.plain(12, theme.palette().text()));
        drawing.fill(List.of(new Vec(1, 1), new Vec(9, 1), new Vec(9, 9)), Theme.faint(theme.series().get(1), 0.2));
        drawing.ring(new Vec(5, 5), 3, Pen.solid(theme.series().get(0), 1));
        return drawing;
    }

    @Test
    void onADarkGroundEveryColourIsTheDarkThemesForTheSame() {
        String dark = drawing().toFile(Appearance.DARK);
        assertTrue(dark.contains("fill=\"" + SvgText.hex(Theme.DARK.palette().canvas()) + "\""), dark);
        assertTrue(dark.contains("fill=\"" + SvgText.hex(Theme.DARK.palette().text()) + "\""), dark);
        assertTrue(dark.contains("stroke=\"" + SvgText.hex(Theme.DARK.series().get(0)) + "\""), dark);
        assertTrue(dark.contains("fill=\"" + SvgText.hex(Theme.DARK.series().get(1)) + "\" fill-opacity"), dark);
        assertFalse(dark.contains(SvgText.hex(Theme.LIGHT.palette().text())), dark);
    }

    @Test
    void anAdaptivePictureIsTheLightOneWithARuleForEachUseOfAColour() throws Exception {
        String adaptive = drawing().toFile(Appearance.ADAPTIVE);
        assertEquals(drawing().toFile(Appearance.LIGHT), adaptive.replaceFirst("(?s)<style>.*</style>\n", ""));
        assertTrue(adaptive.contains("[stroke=\"" + SvgText.hex(Theme.LIGHT.series().get(0)) + "\"] {stroke: "
                + SvgText.hex(Theme.DARK.series().get(0)) + "}"), adaptive);
        assertEquals(1, DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(new InputSource(new java.io.StringReader(adaptive)))
                .getElementsByTagName("style").getLength());
    }

    @Test
    void aColourThatNoThemeHasIsAMistakeOfTheDrawing() {
        SvgDrawing drawing = new SvgDrawing(10, 10, new Color(0x123456));
        assertThrows(IllegalStateException.class, () -> drawing.toFile(Appearance.DARK));
    }
}
