package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.scene.Pixels;
import faultline.paint.surface.Palette;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Animations written and read back. */
class AnimatedGifWriterTest {

    private static final List<BufferedImage> PICTURES = pictures();

    private static List<BufferedImage> pictures() {
        List<BufferedImage> pictures =
                new ArrayList<>(List.of(FrameRenderer.render(SampleFrames.fullFrame(), Palette.LIGHT, 480, 320)));
        for (int i = 0; i < 4; i++) {
            pictures.add(
                    FrameRenderer.render(SampleFrames.frameOf(new Pose(1 + 0.3 * i, 1, 0)), Palette.LIGHT, 480, 320));
        }
        return pictures;
    }

    private static byte[] write(List<BufferedImage> pictures) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (AnimatedGifWriter film = new AnimatedGifWriter(bytes, Palette.LIGHT, 8)) {
            for (int i = 0; i < pictures.size(); i++) {
                film.addFrame(pictures.get(i), 5 + i);
            }
        }
        return bytes.toByteArray();
    }

    private static ImageReader writeAndRead(List<BufferedImage> pictures) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(write(pictures)));
        reader.setInput(in);
        return reader;
    }

    @Test
    void everyPictureKeepsItsDelayAndTheAnimationLoopsForever() throws IOException {
        ImageReader reader = writeAndRead(PICTURES);
        assertEquals(5, reader.getNumImages(true));
        for (int i = 0; i < 5; i++) {
            assertEquals(
                    String.valueOf(5 + i),
                    node(reader, i, "GraphicControlExtension").getAttribute("delayTime"));
        }
        IIOMetadataNode extension = node(reader, 0, "ApplicationExtension");
        assertEquals("NETSCAPE", extension.getAttribute("applicationID"));
        assertArrayEquals(new byte[] {1, 0, 0}, (byte[]) extension.getUserObject());
    }

    /** In hundredths of a second, a second of a run with ticks of 10 ms is a second of the film, and so with others. */
    @ParameterizedTest
    @CsvSource({"0.01, 5, 20", "0.04, 10, 10", "0.1, 10, 10", "0.1, 5, 10", "0.25, 10, 4", "1, 5, 1"})
    void aSecondOfARunTakesASecondOfTheFilm(double dt, int delay, int pictures) {
        int[] delays = IntStream.range(0, (int) Math.round(1 / dt))
                .map(tick -> AnimatedGifWriter.delayOf(tick, dt, delay))
                .filter(shown -> shown > 0)
                .toArray();
        assertEquals(pictures, delays.length);
        assertEquals(100, IntStream.of(delays).sum());
    }

    @Test
    void theFirstTickOfEachIntervalIsShown() {
        assertEquals(
                List.of(0, 3, 5, 8, 10),
                IntStream.rangeClosed(0, 12)
                        .filter(tick -> AnimatedGifWriter.delayOf(tick, 0.04, 10) > 0)
                        .boxed()
                        .toList());
    }

    @Test
    void aTickBeforeTheFilmIsNotShown() {
        assertEquals(0, AnimatedGifWriter.delayOf(-5, 0.01, 5));
        assertEquals(5, AnimatedGifWriter.delayOf(0, 0.01, 5));
    }

    @Test
    void overlaidPicturesEqualTheOriginals() throws IOException {
        ImageReader reader = writeAndRead(PICTURES);
        BufferedImage screen = new BufferedImage(480, 320, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = screen.createGraphics();
        for (int i = 0; i < 5; i++) {
            IIOMetadataNode place = node(reader, i, "ImageDescriptor");
            graphics.drawImage(
                    reader.read(i),
                    Integer.parseInt(place.getAttribute("imageLeftPosition")),
                    Integer.parseInt(place.getAttribute("imageTopPosition")),
                    null);
            assertEquals(0, Pixels.countVisiblyDifferent(PICTURES.get(i), screen), "picture " + i);
        }
    }

    @Test
    void onlyTheChangedAreaIsWritten() throws IOException {
        ImageReader reader = writeAndRead(PICTURES);
        IIOMetadataNode place = node(reader, 3, "ImageDescriptor");
        assertTrue(Integer.parseInt(place.getAttribute("imageWidth")) < 120, place.getAttribute("imageWidth"));
        assertTrue(Integer.parseInt(place.getAttribute("imageHeight")) < 60, place.getAttribute("imageHeight"));
    }

    @Test
    void theChangedAreaHoldsTheDifferencesAndNothingElse() {
        BufferedImage before = new BufferedImage(8, 6, BufferedImage.TYPE_BYTE_INDEXED);
        BufferedImage after = new BufferedImage(8, 6, BufferedImage.TYPE_BYTE_INDEXED);
        assertEquals(new Rectangle(1, 1), AnimatedGifWriter.changedArea(before, after));
        after.setRGB(0, 3, 0xFFFFFF);
        assertEquals(new Rectangle(0, 3, 1, 1), AnimatedGifWriter.changedArea(before, after));
        after.setRGB(0, 3, before.getRGB(0, 3));
        after.setRGB(5, 1, 0xFFFFFF);
        assertEquals(new Rectangle(5, 1, 1, 1), AnimatedGifWriter.changedArea(before, after));
        after.setRGB(2, 4, 0xFFFFFF);
        assertEquals(new Rectangle(2, 1, 4, 4), AnimatedGifWriter.changedArea(before, after));
        after.setRGB(0, 0, 0xFFFFFF);
        after.setRGB(7, 5, 0xFFFFFF);
        assertEquals(new Rectangle(8, 6), AnimatedGifWriter.changedArea(before, after));
    }

    @Test
    void aFileEndsWithATrailer() throws IOException {
        byte[] bytes = write(PICTURES);
        assertEquals(';', bytes[bytes.length - 1]);
    }

    @Test
    void anUnchangedPictureIsWrittenAsOnePixel() throws IOException {
        ImageReader reader = writeAndRead(List.of(PICTURES.get(1), PICTURES.get(1)));
        assertEquals(2, reader.getNumImages(true));
        assertEquals(new Rectangle(1, 1), new Rectangle(reader.getWidth(1), reader.getHeight(1)));
    }

    private static IIOMetadataNode node(ImageReader reader, int image, String name) throws IOException {
        IIOMetadataNode root =
                (IIOMetadataNode) reader.getImageMetadata(image).getAsTree("javax_imageio_gif_image_1.0");
        return (IIOMetadataNode) root.getElementsByTagName(name).item(0);
    }
}
