package faultline.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.geometry.Vec;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.function.BiPredicate;

/** A frame painted without a display, asked about by points of the world. */
public final class Pixels {

    private static final int ALIKE = 70;

    private final BufferedImage image;
    private final Camera camera;

    private Pixels(BufferedImage image, Camera camera) {
        this.image = image;
        this.camera = camera;
    }

    static Pixels of(Frame frame, Palette palette) {
        return new Pixels(FrameImage.render(frame, palette, 900, 640), FrameImage.camera(frame.world(), 900, 640));
    }

    /** The colour some pixels to the right of and below a point of the world. */
    Color at(Vec world, int right, int down) {
        Vec place = camera.toScreen(world);
        return new Color(image.getRGB((int) Math.floor(place.x()) + right, (int) Math.floor(place.y()) + down));
    }

    void assertColour(Color expected, Vec world) {
        assertEquals(name(expected), name(at(world, 0, 0)), "at " + world);
    }

    /**
     * Whether a colour, or nearly that because fine lines blend with what is beneath, occurs within so many pixels of a point of
     * the world.
     */
    boolean hasNear(Color colour, Vec world, int pixels) {
        for (int right = -pixels; right <= pixels; right++) {
            for (int down = -pixels; down <= pixels; down++) {
                if (isNearly(colour, at(world, right, down))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isNearly(Color a, Color b) {
        return Math.abs(a.getRed() - b.getRed()) < ALIKE && Math.abs(a.getGreen() - b.getGreen()) < ALIKE
                && Math.abs(a.getBlue() - b.getBlue()) < ALIKE;
    }

    /** How many pixels differ between two pictures of one size. */
    public static int differing(BufferedImage a, BufferedImage b) {
        return count(a, b, (one, other) -> !one.equals(other));
    }

    /** How many pixels differ so much between two pictures of one size that an eye sees it. */
    public static int unlike(BufferedImage a, BufferedImage b) {
        return count(a, b, (one, other) -> !isNearly(one, other));
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

    private static String name(Color colour) {
        return String.format(Locale.ROOT, "#%06X", colour.getRGB() & 0xFFFFFF);
    }
}
