package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShortenedTextTest {

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private static FontMetrics metrics() {
        Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        FontMetrics metrics = graphics.getFontMetrics(FONT);
        graphics.dispose();
        return metrics;
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "front", "a-very-long-sensor-identifier", "<html><b>bold</b>"})
    void aTextIsShortenedAsThatOfALabel(String text) {
        for (int width = 0; width < 300; width++) {
            assertEquals(ofLabel(text, width), ShortenedText.of(text, metrics(), width), "in " + width + " pixels");
        }
    }

    private static String ofLabel(String text, int width) {
        return SwingUtilities.layoutCompoundLabel(
                metrics(),
                text,
                null,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                new Rectangle(0, 0, width, 20),
                new Rectangle(),
                new Rectangle(),
                0);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\u0645\u0633\u062a\u0634\u0639\u0631 \u0623\u0645\u0627\u0645\u064a",
                "\u524d\u65b9\u7ea2\u5916\u4f20\u611f\u5668",
                "\ud83d\ude00\ud83e\udd16\ud83d\udea7 sensor"
            })
    void aTextOfAnotherScriptIsNotDividedInACharacter(String text) {
        int whole = metrics().stringWidth(text);
        assertEquals(text, ShortenedText.of(text, metrics(), whole));
        for (int width = 20; width < whole; width++) {
            String shortened = ShortenedText.of(text, metrics(), width);
            String start = shortened.replace("...", "");
            assertTrue(shortened.endsWith("...") && text.startsWith(start), shortened);
            assertFalse(!start.isEmpty() && Character.isHighSurrogate(start.charAt(start.length() - 1)), shortened);
        }
    }
}
