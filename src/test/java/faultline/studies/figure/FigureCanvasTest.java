package faultline.studies.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class FigureCanvasTest {

    private static final String CAPTION = "Every word of a caption is in the picture, in lines that fit its width.";

    @Test
    void aCaptionStandsBelowThePictureInLinesThatFit() {
        List<String> lines = FigureCanvas.SMALL_TEXT.wrap(CAPTION, 172);
        assertEquals(CAPTION, String.join(" ", lines));
        assertTrue(lines.size() > 2, lines.toString());
        String svg = new FigureCanvas(200, 100, CAPTION).surface().toSvg();
        assertTrue(svg.contains("height=\"" + (100 + 14 + 15 * lines.size()) + "\""), svg);
        lines.forEach(line -> {
            assertTrue(FigureCanvas.SMALL_TEXT.estimateWidth(line) <= 172, line);
            assertTrue(svg.contains(">" + line + "<"), line);
        });
    }

    @Test
    void aWordThatIsTooLongHasALineOfItsOwn() {
        assertEquals(List.of("a", "measurement", "is"), FigureCanvas.SMALL_TEXT.wrap("  a measurement\n is ", 20));
    }

    @Test
    void panelsAreLettered() {
        assertEquals("(a) ahead", FigureCanvas.panelTitle(0, "ahead"));
        assertEquals("(i) last", FigureCanvas.panelTitle(8, "last"));
    }
}
