package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.function.BiPredicate;

/** The pixels of a frame painted without a display, addressed by points of the world. */
public final class Pixels {

    private static final int COLOUR_TOLERANCE = 70;

    private final BufferedImage image;
    private final Camera camera;

    private Pixels(BufferedImage image, Camera camera) {
        this.image = image;
        this.camera = camera;
    }

    static Pixels render(Frame frame, Palette palette) {
        return new Pixels(
                FrameRenderer.render(frame, palette, 900, 640), FrameRenderer.fitCamera(frame.snapshot(), 900, 640));
    }

    /** Returns the colour at an offset in pixels to the right of and below a point of the world. */
    Color colourAt(Vector2 world, int right, int down) {
        Vector2 place = camera.toScreen(world);
        return new Color(image.getRGB((int) Math.floor(place.x()) + right, (int) Math.floor(place.y()) + down));
    }

    void assertColour(Color expected, Vector2 world) {
        assertEquals(toHex(expected), toHex(colourAt(world, 0, 0)), "at " + world);
    }

    /**
     * Returns whether a colour, or a similar one because fine lines are blended, occurs within a number of pixels of a
     * point of the world.
     */
    boolean hasNear(Color colour, Vector2 world, int pixels) {
        for (int right = -pixels; right <= pixels; right++) {
            for (int down = -pixels; down <= pixels; down++) {
                if (isSimilar(colour, colourAt(world, right, down))) {
                    return true;
                }
            }
        }
        return false;
    }

    static boolean isSimilar(Color a, Color b) {
        return Math.abs(a.getRed() - b.getRed()) < COLOUR_TOLERANCE
                && Math.abs(a.getGreen() - b.getGreen()) < COLOUR_TOLERANCE
                && Math.abs(a.getBlue() - b.getBlue()) < COLOUR_TOLERANCE;
    }

    /** Returns the number of pixels that differ between two pictures of one size. */
    public static int countDifferent(BufferedImage a, BufferedImage b) {
        return count(a, b, (one, other) -> !one.equals(other));
    }

    /** Returns the number of pixels that differ visibly between two pictures of one size. */
    public static int countVisiblyDifferent(BufferedImage a, BufferedImage b) {
        return count(a, b, (one, other) -> !isSimilar(one, other));
    }

    private static int count(BufferedImage a, BufferedImage b, BiPredicate<Color, Color> counts) {
        assertEquals(a.getWidth() + "x" + a.getHeight(), b.getWidth() + "x" + b.getHeight());
        int counted = 0;
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                counted += counts.test(new Color(a.getRGB(x, y)), new Color(b.getRGB(x, y))) ? 1 : 0;
            }
        }
        return counted;
    }

    private static String toHex(Color colour) {
        return String.format(Locale.ROOT, "#%06X", colour.getRGB() & 0xFFFFFF);
    }
}
