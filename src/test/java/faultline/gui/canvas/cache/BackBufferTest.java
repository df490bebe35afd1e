package faultline.gui.canvas.cache;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A component of 90 by 70 pixels at a position on a device with more pixels, including fractional scales. */
class BackBufferTest {

    private static final int WIDTH = 90;
    private static final int HEIGHT = 70;
    private static final int DEVICE = 400;
    private static final int PARTS = 200;

    private final BackBuffer backBuffer = new BackBuffer();
    private final BufferedImage device = new BufferedImage(DEVICE, DEVICE, BufferedImage.TYPE_INT_RGB);

    /** Thin slanted lines, which reveal every device pixel that is blurred, doubled or missing. */
    private static void lines(Graphics2D graphics, Color colour) {
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, WIDTH, HEIGHT);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(colour);
        graphics.setStroke(new BasicStroke(0.7F));
        for (int x = -HEIGHT; x < WIDTH; x += 3) {
            graphics.drawLine(x, 0, x + HEIGHT, HEIGHT);
        }
    }

    private Graphics2D graphics(double scale, int x, int y) {
        Graphics2D graphics = device.createGraphics();
        graphics.scale(scale, scale);
        graphics.translate(x, y);
        return graphics;
    }

    private static BufferedImage plain(double scale, Color colour) {
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(WIDTH * scale), (int) Math.ceil(HEIGHT * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.scale(scale, scale);
        lines(graphics, colour);
        graphics.dispose();
        return image;
    }

    @ParameterizedTest
    @CsvSource({"1, 7, 3", "1.25, 7, 3", "1.25, 5, 2", "1.25, 6, 6", "1.5, 7, 3", "1.5, 5, 2", "1.75, 7, 1", "2, 7, 3"})
    void eachPixelOfTheBufferIsOneOfTheDevice(double scale, int x, int y) {
        Graphics2D graphics = graphics(scale, x, y);
        backBuffer.paint(graphics, WIDTH, HEIGHT, own -> lines(own, Color.BLACK));
        graphics.dispose();
        BufferedImage wanted = plain(scale, Color.BLACK);
        int left = first(x * scale);
        int top = first(y * scale);
        assertEquals(0, differingPixels(wanted, device.getSubimage(left, top, wanted.getWidth(), wanted.getHeight())));
    }

    @ParameterizedTest
    @CsvSource({"1, 7, 3", "1.25, 7, 3", "1.25, 5, 2", "1.25, 6, 6", "1.5, 7, 3", "1.5, 5, 2", "1.75, 7, 1", "2, 7, 3"})
    void aRepaintedPartShowsNothingOfTheOldImage(double scale, int x, int y) {
        Random random = new Random(1);
        int left = first(x * scale);
        int top = first(y * scale);
        BufferedImage black = plain(scale, Color.BLACK);
        BufferedImage red = plain(scale, Color.RED);
        for (int i = 0; i < PARTS; i++) {
            Graphics2D graphics = graphics(scale, x, y);
            backBuffer.paint(graphics, WIDTH, HEIGHT, own -> lines(own, Color.BLACK));
            Rectangle part = new Rectangle(
                    random.nextInt(WIDTH / 2),
                    random.nextInt(HEIGHT / 2),
                    1 + random.nextInt(40),
                    1 + random.nextInt(30));
            graphics.clip(part);
            backBuffer.paint(graphics, WIDTH, HEIGHT, own -> lines(own, Color.RED));
            BufferedImage wanted = new BufferedImage(black.getWidth(), black.getHeight(), BufferedImage.TYPE_INT_RGB);
            wanted.setData(black.getData());
            Graphics2D patch = wanted.createGraphics();
            patch.translate(-left, -top);
            patch.scale(scale, scale);
            patch.translate(x, y);
            patch.clip(part);
            patch.setTransform(new AffineTransform());
            patch.drawImage(red, 0, 0, null);
            patch.dispose();
            graphics.dispose();
            assertEquals(
                    0,
                    differingPixels(wanted, device.getSubimage(left, top, wanted.getWidth(), wanted.getHeight())),
                    part.toString());
        }
    }

    /** Returns the first pixel whose centre is not before an edge. */
    private static int first(double edge) {
        return (int) Math.ceil(edge - 0.5);
    }

    private static long differingPixels(BufferedImage wanted, BufferedImage seen) {
        long unlike = 0;
        for (int y = 0; y < wanted.getHeight(); y++) {
            for (int x = 0; x < wanted.getWidth(); x++) {
                unlike += wanted.getRGB(x, y) == seen.getRGB(x, y) ? 0 : 1;
            }
        }
        return unlike;
    }
}
