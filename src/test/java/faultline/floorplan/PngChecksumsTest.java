package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.gui.text.Translations;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** PNG images in which one bit is wrong. */
class PngChecksumsTest {

    /** The transparent colour is the third of these. */
    private static final IndexColorModel BLACK_WHITE_CLEAR =
            new IndexColorModel(2, 3, new byte[] {0, -1, 0}, new byte[] {0, -1, 0}, new byte[] {0, -1, 0}, 2);

    @TempDir
    private Path folder;

    private Path file;
    private byte[] good;

    @BeforeEach
    void aPngWithAPalette() throws IOException {
        file = folder.resolve("map.png");
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_BYTE_BINARY, BLACK_WHITE_CLEAR);
        image.getRaster().setPixels(0, 0, 3, 1, new int[] {0, 1, 2});
        ImageIO.write(image, "png", file.toFile());
        good = Files.readAllBytes(file);
    }

    /** Returns the place of the name of a chunk. */
    private int place(String chunk) {
        return new String(good, StandardCharsets.ISO_8859_1).indexOf(chunk);
    }

    private void flipBit(int place) throws IOException {
        byte[] damaged = good.clone();
        damaged[place] ^= (byte) 0x80;
        Files.write(file, damaged);
    }

    @ParameterizedTest
    @ValueSource(strings = {"IHDR", "PLTE", "tRNS", "IDAT"})
    void aWrongBitIsReportedWithItsChunk(String chunk) throws IOException {
        for (int offset : new int[] {4, lengthOf(chunk) + 4}) {
            flipBit(place(chunk) + offset);
            FloorPlanException e = assertThrows(FloorPlanException.class, () -> MapImageReader.read(file));
            assertEquals(
                    file + ": the checksum of the chunk " + chunk + " at byte " + (place(chunk) - 4)
                            + " is wrong; the image is damaged",
                    e.getMessage());
            Translations.assertTranslated(e.reason());
        }
    }

    private int lengthOf(String chunk) {
        return good[place(chunk) - 1];
    }

    /** It has no content. */
    @Test
    void theLastChunkIsNotChecked() throws IOException {
        flipBit(place("IEND") + 4);
        assertEquals(3, MapImageReader.read(file).width());
    }
}
