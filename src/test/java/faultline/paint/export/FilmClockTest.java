package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.paint.scene.Pixels;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.Palette;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

/** The time in an image of 200 by 100 pixels. */
class FilmClockTest {

    private static BufferedImage image() {
        BufferedImage image = new BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(Color.RED);
        graphics.fillRect(0, 0, 200, 100);
        graphics.dispose();
        return image;
    }

    private static BufferedImage imageAt(double time) {
        BufferedImage image = image();
        FilmClock.paint(image, time, Palette.LIGHT);
        return image;
    }

    /** The box of the text is 14 + 2 * 4 pixels high and ends 6 pixels above the lower edge. */
    @Test
    void theTimeIsInABoxInTheMiddleOfTheLowerEdge() {
        TextStyle style = TextStyle.plain(14, Palette.LIGHT.text());
        double width = style.estimateWidth("12.3 s") + 8;
        BufferedImage expected = image();
        Graphics2D graphics = expected.createGraphics();
        GraphicsSurface surface = new GraphicsSurface(graphics);
        surface.fill(new Rectangle2D.Double(100 - width / 2, 72, width, 22), Palette.LIGHT.canvas());
        surface.drawText("12.3 s", new Vector2(104 - width / 2, 87.9), style);
        graphics.dispose();
        assertEquals(0, Pixels.countDifferent(expected, imageAt(12.34)));
    }

    @Test
    void timesThatDifferInTheirFirstDecimalLookDifferent() {
        assertEquals(0, Pixels.countDifferent(imageAt(12.34), imageAt(12.26)));
        assertTrue(Pixels.countDifferent(imageAt(12.34), imageAt(12.36)) > 0);
    }
}
