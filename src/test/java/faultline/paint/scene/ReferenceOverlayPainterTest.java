package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ReferenceOverlayPainterTest {

    private static final int WIDTH = 800;
    private static final int HEIGHT = 500;
    private static final Rectangle PICTURE = new Rectangle(WIDTH, HEIGHT);

    @Test
    void theCaptionLeavesTheScaleBarVisible() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        DrawContext context = new DrawContext(graphics, new Camera(0, 8, 60, WIDTH, HEIGHT), Palette.LIGHT);
        context.fill(PICTURE, Palette.LIGHT.canvas());
        ScaleBarPainter.paint(context);
        Rectangle bar = ScaleBarPainter.area(context).getBounds();
        int[] before = pixels(image, bar);
        int[] above = pixels(image, aboveOf(bar));
        ReferenceOverlayPainter.paintAnnotations(
                context,
                SampleReferenceOverlays.office(),
                SampleFrames.frameOf(new Pose(1, 6, 0)).snapshot(),
                new CornerChoice(CornerChoice.Corner.LOWER_RIGHT),
                List.of());
        graphics.dispose();
        assertArrayEquals(before, pixels(image, bar));
        assertFalse(Arrays.equals(above, pixels(image, aboveOf(bar))), "the caption is above the bar");
    }

    private static Rectangle aboveOf(Rectangle bar) {
        return new Rectangle(bar.x, bar.y - 20, bar.width, 20);
    }

    private static int[] pixels(BufferedImage image, Rectangle area) {
        return image.getRGB(area.x, area.y, area.width, area.height, null, 0, area.width);
    }
}
