package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The scale bar of a picture of 600 by 400 pixels. */
class ScaleBarPainterTest {

    /** A bar is at least 60 pixels long; with 100 pixels a metre, that is 0.6 m, and the next nice length is 1 m. */
    @ParameterizedTest
    @CsvSource({"6, 1 m, 100", "15, 2 m, 80", "30, 5 m, 100", "4, 50 cm, 75"})
    void theLengthOfTheBarIsTheOneThatItSays(double metresAcross, String name, double pixels) {
        RecordingSurface drawn = new RecordingSurface();
        Camera camera = Camera.fit(new Rectangle2D.Double(0, 0, metresAcross, metresAcross * 2 / 3), 0, 600, 400);
        DrawContext context = new DrawContext(drawn, camera, Palette.LIGHT, DrawContext.DEFAULT_FONT);
        ScaleBarPainter.paint(context);
        List<RecordingSurface.DrawnShape> bars = drawn.shapes(Palette.LIGHT.text());
        assertEquals(1, bars.size());
        Rectangle2D bar = bars.get(0).shape().getBounds2D();
        assertEquals(pixels, bar.getWidth(), 1e-9);
        String left = Math.round((576.5 - pixels) * 10) / 10.0 + ",";
        assertEquals(
                left + "389.5 " + left + "397.5 " + left + "393.5 576.5,393.5 576.5,389.5 576.5,397.5",
                bars.get(0).toString(),
                "24 pixels from the right edge and 7 from the lower one");
        assertEquals(1, drawn.texts().size());
        assertTrue(drawn.texts().get(0).startsWith(name + " at "), drawn.texts()::toString);
        Rectangle2D area = ScaleBarPainter.area(context);
        assertTrue(area.contains(bar), area + " without " + bar);
    }
}
