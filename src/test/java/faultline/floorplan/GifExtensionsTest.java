package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.CpuTime;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** GIF images with comments and other extensions. */
class GifExtensionsTest {

    /** The transparent colour is the third of these. */
    private static final IndexColorModel BLACK_WHITE_CLEAR =
            new IndexColorModel(2, 3, new byte[] {0, -1, 0}, new byte[] {0, -1, 0}, new byte[] {0, -1, 0}, 2);

    private static final int COMMENT = 0xfe;
    private static final int APPLICATION = 0xff;

    @TempDir
    private Path folder;

    private Path file;
    private byte[] plain;

    /** An image of a black, a white and a transparent pixel. */
    @BeforeEach
    void aGifWithoutComments() throws IOException {
        file = folder.resolve("map.gif");
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_BYTE_BINARY, BLACK_WHITE_CLEAR);
        image.getRaster().setPixels(0, 0, 3, 1, new int[] {0, 1, 2});
        ImageIO.write(image, "gif", file.toFile());
        plain = Files.readAllBytes(file);
    }

    /** Writes the image with an extension of blocks of 255 bytes before its other blocks. */
    private void insert(int label, int blocks) throws IOException {
        int start = 13 + ((plain[10] & 0x80) == 0 ? 0 : 3 << (plain[10] & 7) + 1);
        byte[] block = new byte[256];
        Arrays.fill(block, (byte) 255);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(plain, 0, start);
        out.write(0x21);
        out.write(label);
        for (int i = 0; i < blocks; i++) {
            out.write(block);
        }
        out.write(0);
        out.write(plain, start, plain.length - start);
        Files.write(file, out.toByteArray());
    }

    private void assertPixels() throws IOException {
        MapImage map = MapImageReader.read(file);
        OccupancyGrid grid = MapDescription.of(file, BigDecimal.ONE).classify(map);
        assertEquals(CellState.OCCUPIED, grid.state(0, 0));
        assertEquals(CellState.FREE, grid.state(1, 0));
        assertEquals(CellState.UNKNOWN, grid.state(2, 0));
    }

    @Test
    void extensionsBeforeTheImageDoNotChangeItsPixels() throws IOException {
        assertPixels();
        insert(COMMENT, 3);
        assertPixels();
        insert(APPLICATION, 1);
        assertPixels();
    }

    @Test
    void aLongCommentIsSkippedInLinearTime() throws IOException {
        insert(COMMENT, 60_000);
        CpuTime time = CpuTime.start();
        assertPixels();
        time.assertBelow(20);
    }

    @Test
    void aGifThatEndsInAnExtensionIsReportedInWords() throws IOException {
        insert(COMMENT, 3);
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(whole, 600));
        FloorPlanException e = assertThrows(FloorPlanException.class, () -> MapImageReader.read(file));
        assertEquals(file + ": the image cannot be read: the file ends too early", e.getMessage());
    }
}
