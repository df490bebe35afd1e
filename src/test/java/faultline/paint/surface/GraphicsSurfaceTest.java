package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is painted into images of 200 x 200 pixels, on white. */
class GraphicsSurfaceTest {

    private static final int SIZE = 200;
    private static final TextStyle TEXT = TextStyle.plain(40, Color.RED);
    private static final Font FONT = TEXT.font();

    private static BufferedImage paint(Consumer<Graphics2D> painter) {
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, SIZE, SIZE);
        painter.accept(graphics);
        graphics.dispose();
        return image;
    }

    private static BufferedImage text(String text, double x, double y, TextStyle style) {
        return paint(graphics -> new GraphicsSurface(graphics).drawText(text, new Vector2(x, y), style));
    }

    /** Returns the bounds of the pixels in some columns that meet a condition. */
    private static Rectangle bounds(BufferedImage image, int left, int right, Predicate<Color> condition) {
        Rectangle bounds = null;
        for (int x = left; x < right; x++) {
            for (int y = 0; y < SIZE; y++) {
                if (condition.test(new Color(image.getRGB(x, y)))) {
                    Rectangle pixel = new Rectangle(x, y, 1, 1);
                    bounds = bounds == null ? pixel : bounds.union(pixel);
                }
            }
        }
        return bounds;
    }

    /** Returns the bounds of letters; pixels that they only touch are left out. */
    private static Rectangle ink(BufferedImage image) {
        return bounds(image, 0, SIZE, GraphicsSurfaceTest::isRed);
    }

    private static boolean isRed(Color colour) {
        return colour.getRed() > 200 && colour.getGreen() < 128 && colour.getBlue() < 128;
    }

    private static void assertNear(Rectangle2D expected, Rectangle2D actual, double tolerance) {
        assertTrue(
                Math.abs(expected.getMinX() - actual.getMinX()) <= tolerance
                        && Math.abs(expected.getMinY() - actual.getMinY()) <= tolerance
                        && Math.abs(expected.getMaxX() - actual.getMaxX()) <= tolerance
                        && Math.abs(expected.getMaxY() - actual.getMaxY()) <= tolerance,
                () -> expected + " and " + actual);
    }

    /** Returns the outline of a text whose baseline starts at a point, from the JDK. */
    private static Rectangle2D outline(String text, double x, double y) {
        return FONT.createGlyphVector(DrawContext.FONT_CONTEXT, text)
                .getOutline((float) x, (float) y)
                .getBounds2D();
    }

    @ParameterizedTest
    @CsvSource({"START, 0", "MIDDLE, 0.5", "END, 1"})
    void aTextHasItsAnchorAtItsPosition(TextStyle.Anchor anchor, double share) {
        double width = FONT.getStringBounds("HIH", DrawContext.FONT_CONTEXT).getWidth();
        Rectangle2D expected = outline("HIH", 100 - share * width, 80);
        assertNear(expected, ink(text("HIH", 100, 80, TEXT.withAnchor(anchor))), 1.5);
    }

    @Test
    void aRotatedTextRunsUpwards() {
        Rectangle2D level = outline("HIH", 0, 0);
        Rectangle2D expected = new Rectangle2D.Double(
                70 + level.getMinY(), 150 - level.getMaxX(), level.getHeight(), level.getWidth());
        assertNear(expected, ink(text("HIH", 70, 150, TEXT.rotated())), 1.5);
    }

    @Test
    void aSubscriptIsSmallerLowerAndBehindItsLetter() {
        BufferedImage image = text("I_I", 50, 80, TEXT);
        int middle =
                50 + (int) FONT.getStringBounds("I", DrawContext.FONT_CONTEXT).getWidth();
        Rectangle letter = bounds(image, 0, middle, GraphicsSurfaceTest::isRed);
        Rectangle subscript = bounds(image, middle, SIZE, GraphicsSurfaceTest::isRed);
        assertEquals(10, subscript.getMaxY() - letter.getMaxY(), 1, "a quarter of the size");
        assertEquals(0.75 * letter.height, subscript.height, 1.5);
    }

    @Test
    void aTextWithAnUnderscoreHasTheWidthOfItsParts() {
        Rectangle2D end = ink(text("H_H", 150, 80, TEXT.withAnchor(TextStyle.Anchor.END)));
        assertTrue(end.getMaxX() <= 150 && end.getMaxX() > 144, end::toString);
    }

    @Test
    void aBoldTextIsBold() {
        assertTrue(TEXT.withBold().font().isBold());
        assertTrue(TEXT.font().isPlain());
    }

    /** Upright at a scale of 1.5 it is an image; turned it is an outline. */
    @ParameterizedTest
    @CsvSource({"1, 0", "1.5, 0", "1, 1", "1.5, 1"})
    void aTextHasItsHaloAroundItAtAnyScaleAndTurn(double scale, int quarterTurns) {
        BufferedImage image = paint(graphics -> {
            graphics.translate(60, 120);
            graphics.scale(scale, scale);
            graphics.rotate(-quarterTurns * Math.PI / 2);
            new GraphicsSurface(graphics).drawHaloedText("HI", 0, 0, Color.RED, Color.BLUE, FONT);
        });
        Rectangle2D level = outline("HI", 0, 0);
        Rectangle2D expected = quarterTurns == 0
                ? level
                : new Rectangle2D.Double(level.getMinY(), -level.getMaxX(), level.getHeight(), level.getWidth());
        Rectangle2D letters = new Rectangle2D.Double(
                60 + scale * expected.getX(),
                120 + scale * expected.getY(),
                scale * expected.getWidth(),
                scale * expected.getHeight());
        assertNear(letters, ink(image), 1.5);
        double halo = scale * 3.5 / 2;
        Rectangle2D around = new Rectangle2D.Double(
                letters.getX() - halo,
                letters.getY() - halo,
                letters.getWidth() + 2 * halo,
                letters.getHeight() + 2 * halo);
        assertNear(around, bounds(image, 0, SIZE, colour -> colour.getBlue() > 200 && colour.getRed() < 128), 1.5);
    }

    @Test
    void aCrossHasBothDiagonals() {
        BufferedImage image =
                paint(graphics -> new DrawContext(graphics, new Camera(0, 0, 1, SIZE, SIZE), Palette.LIGHT)
                        .drawCross(new Rectangle(20, 40, 100, 60), Color.RED));
        for (int share = 1; share < 10; share++) {
            assertTrue(isRed(new Color(image.getRGB(20 + 10 * share, 40 + 6 * share))), "down " + share);
            assertTrue(isRed(new Color(image.getRGB(20 + 10 * share, 100 - 6 * share))), "up " + share);
        }
    }

    @Test
    void aRingHasAHaloOfTheCanvasOnBothSides() {
        BufferedImage image = paint(graphics -> {
            graphics.setColor(Color.BLACK);
            graphics.fillRect(0, 0, SIZE, SIZE);
            new DrawContext(graphics, new Camera(0, 0, 1, SIZE, SIZE), Palette.LIGHT)
                    .drawRing(new Vector2(100.5, 100.5), 50, 3, Color.RED);
        });
        assertTrue(isRed(new Color(image.getRGB(150, 100))));
        for (int x : new int[] {148, 152}) {
            Color halo = new Color(image.getRGB(x, 100));
            assertTrue(halo.getBlue() > 60 && halo.getRed() - halo.getBlue() < 60, x + ": " + halo);
        }
        assertEquals(Color.BLACK, new Color(image.getRGB(146, 100)));
        assertEquals(Color.BLACK, new Color(image.getRGB(155, 100)));
    }

    @Test
    void thinLinesHaveRoughEdgesAndWhatFollowsHasNot() {
        Line2D line = new Line2D.Double(10, 10, 190, 60);
        assertEquals(0, countMixed(paint(graphics -> new GraphicsSurface(graphics).drawThin(line, Color.RED))));
        BufferedImage both = paint(graphics -> {
            GraphicsSurface surface = new GraphicsSurface(graphics);
            surface.drawThin(line, Color.RED);
            surface.draw(new Line2D.Double(10, 110, 190, 160), Color.RED, new BasicStroke(1));
        });
        assertTrue(countMixed(both) > 100);
    }

    private static long countMixed(BufferedImage image) {
        return Arrays.stream(image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE))
                .filter(rgb -> rgb != Color.WHITE.getRGB() && rgb != Color.RED.getRGB())
                .count();
    }
}
