package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Images that the JDK's readers do not read as the formats define them. */
class MapImageReaderTest {

    @TempDir
    private Path folder;

    /** Writes a grey PNG with one row of all levels from black to white, one of which is transparent. */
    private Path greyPng(int bits, int transparent) throws IOException {
        int size = 1 << bits;
        ByteArrayOutputStream row = new ByteArrayOutputStream();
        row.write(0); // no filter
        int packed = 1;
        for (int level = 0; level < size; level++) {
            packed = packed << bits | level;
            if (packed >= 256) {
                row.write(packed);
                packed = 1;
            }
        }
        if (packed > 1) {
            row.write(packed << 8 - bits * size);
        }
        ByteArrayOutputStream pixels = new ByteArrayOutputStream();
        try (DeflaterOutputStream out = new DeflaterOutputStream(pixels)) {
            row.writeTo(out);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        png.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        writeChunk(png, "IHDR", bytes(0, 0, size >> 8, size, 0, 0, 0, 1, bits, 0, 0, 0, 0));
        writeChunk(png, "tRNS", bytes(transparent >> 8, transparent));
        writeChunk(png, "IDAT", pixels.toByteArray());
        writeChunk(png, "IEND", bytes());
        return Files.write(folder.resolve("grey.png"), png.toByteArray());
    }

    private static byte[] bytes(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    private static void writeChunk(ByteArrayOutputStream png, String type, byte[] content) throws IOException {
        ByteArrayOutputStream chunk = new ByteArrayOutputStream();
        chunk.writeBytes(type.getBytes(StandardCharsets.US_ASCII));
        chunk.writeBytes(content);
        CRC32 checksum = new CRC32();
        checksum.update(chunk.toByteArray());
        DataOutputStream out = new DataOutputStream(png);
        out.writeInt(content.length);
        chunk.writeTo(out);
        out.writeInt((int) checksum.getValue());
    }

    @ParameterizedTest
    @CsvSource({"1,0", "1,1", "2,0", "2,1", "2,2", "2,3", "4,0", "4,7", "4,15", "8,0", "8,254", "8,255"})
    void theTransparentLevelOfAGreyPngIsThatOfItsPixels(int bits, int transparent) throws IOException {
        MapImage map = MapImageReader.read(greyPng(bits, transparent));
        int max = (1 << bits) - 1;
        for (int level = 0; level <= max; level++) {
            assertEquals(level == transparent, map.isTransparent(level, 0), "level " + level);
            assertEquals(level * 255 / max, map.sample(level, 0) * 255 / map.white(), "level " + level);
        }
    }

    /** Returns an image of three columns and two rows, whose samples are 10 to 60 in the order of reading. */
    private static BufferedImage twoRows(BufferedImage image) {
        for (int i = 0; i < 6; i++) {
            for (int band = 0; band < image.getRaster().getNumBands(); band++) {
                image.getRaster().setSample(i % 3, i / 3, band, 10 * (i + 1));
            }
        }
        return image;
    }

    private MapImage asPng(BufferedImage image) throws IOException {
        Path file = folder.resolve("rows.png");
        ImageIO.write(image, "png", file.toFile());
        return MapImageReader.read(file);
    }

    private static void assertTwoRows(MapImage map) {
        assertEquals(3, map.width());
        assertEquals(2, map.height());
        for (int i = 0; i < 6; i++) {
            assertEquals(10 * (i + 1), map.sample(i % 3, i / 3) * 255 / map.white(), "pixel " + i);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_INT_RGB})
    void everyRowOfAnImageIsInItsPlace(int type) throws IOException {
        MapImage map = asPng(twoRows(new BufferedImage(3, 2, type)));
        assertTwoRows(map);
        assertFalse(map.isTransparent(0, 0));
    }

    @Test
    void everyRowOfAGreyImageWithOpacityIsInItsPlace() throws IOException {
        ColorModel grey = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_GRAY),
                true,
                false,
                Transparency.TRANSLUCENT,
                DataBuffer.TYPE_BYTE);
        BufferedImage image = twoRows(new BufferedImage(grey, grey.createCompatibleWritableRaster(3, 2), false, null));
        for (int i = 0; i < 6; i++) {
            image.getRaster().setSample(i % 3, i / 3, 1, i == 4 ? 254 : 255);
        }
        MapImage map = asPng(image);
        assertTwoRows(map);
        image.getRaster().setSample(0, 0, 0, 1);
        assertFalse(asPng(image).isTransparent(0, 0), "the darkest grey");
        for (int i = 0; i < 6; i++) {
            assertEquals(i == 4, map.isTransparent(i % 3, i / 3), "pixel " + i);
        }
    }

    @Test
    void unusedBitsOfATransparentLevelDoNotCount() throws IOException {
        MapImage map = MapImageReader.read(greyPng(2, 0x0107));
        assertFalse(map.isTransparent(2, 0));
        assertTrue(map.isTransparent(3, 0));
    }

    /** Writes a TIFF of three pixels with a grey and an opacity of 8 bits each. */
    private Path greyTiff(int photometric, int extraSample, int... samples) throws IOException {
        int[][] tags = {
            {256, 3},
            {257, 1},
            {258, 8 << 16 | 8},
            {259, 1},
            {262, photometric},
            {273, 8},
            {277, 2},
            {279, 6},
            {338, extraSample}
        };
        ByteBuffer tiff = ByteBuffer.allocate(20 + 12 * tags.length).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put(bytes('I', 'I', 42, 0)).putInt(14).put(bytes(samples)).putShort((short) tags.length);
        for (int[] tag : tags) {
            tiff.putShort((short) tag[0]).putShort((short) 3).putInt(tag[0] == 258 ? 2 : 1);
            tiff.putInt(tag[1]);
        }
        return Files.write(folder.resolve("grey.tiff"), tiff.array());
    }

    @ParameterizedTest
    @CsvSource({"0,1", "0,2", "1,1", "1,2"})
    void aTiffWithOpacityMayStoreWhiteOrBlackAsZero(int photometric, int extraSample) throws IOException {
        MapImage map = MapImageReader.read(greyTiff(photometric, extraSample, 0, 255, 255, 255, 60, 254));
        int[] expected = photometric == 0 ? new int[] {255, 0, 195} : new int[] {0, 255, 60};
        for (int x = 0; x < 3; x++) {
            assertEquals(expected[x], map.sample(x, 0), "pixel " + x);
            assertEquals(x == 2, map.isTransparent(x, 0), "pixel " + x);
        }
    }

    /** Writes a GIF of 2 x 1 pixels, black and white, at a place on a screen. */
    private Path gif(int screenWidth, int screenHeight, int left, int top) throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_BYTE_BINARY);
        image.setRGB(1, 0, 0xffffffff);
        Path file = folder.resolve("part.gif");
        ImageIO.write(image, "gif", file.toFile());
        ByteBuffer gif = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        gif.putShort(6, (short) screenWidth).putShort(8, (short) screenHeight);
        int descriptor = new String(gif.array(), StandardCharsets.ISO_8859_1).indexOf(",\0\0\0\0\2\0\1\0");
        gif.putShort(descriptor + 1, (short) left).putShort(descriptor + 3, (short) top);
        return Files.write(file, gif.array());
    }

    @Test
    void aGifWhoseImageCoversAPartOfTheScreenIsAsLargeAsTheScreen() throws IOException {
        MapImage map = MapImageReader.read(gif(4, 3, 1, 2));
        assertEquals(4, map.width());
        assertEquals(3, map.height());
        for (int y = 0; y < 3; y++) {
            for (int x = 0; x < 4; x++) {
                boolean isCovered = y == 2 && (x == 1 || x == 2);
                assertEquals(!isCovered, map.isTransparent(x, y), x + "," + y);
            }
        }
        assertEquals(0, map.sample(1, 2));
        assertEquals(map.white(), map.sample(2, 2));
    }

    @ParameterizedTest
    @CsvSource({"2, 3, 0, 1", "4, 2, 1, 0", "4, 4, 1, 1"})
    void everyPixelOfAPartHasItsPlaceInTheWhole(int width, int height, int left, int top) {
        MapImage part = new MapImage(2, 2, 9);
        for (int i = 0; i < 4; i++) {
            part.set(i, i + 1, i == 1);
        }
        MapImage whole = part.on(width, height, left, top);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                boolean isCovered = x >= left && x < left + 2 && y >= top && y < top + 2;
                String place = x + "," + y;
                assertEquals(isCovered ? part.sample(x - left, y - top) : 0, whole.sample(x, y), place);
                assertEquals(!isCovered || part.isTransparent(x - left, y - top), whole.isTransparent(x, y), place);
            }
        }
    }

    @Test
    void aFolderIsNoImage() {
        FloorPlanException e = assertThrows(FloorPlanException.class, () -> MapImageReader.read(folder));
        assertEquals(folder + ": this is not a regular file; expected an image file", e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"4, BI_JPEG", "5, BI_PNG"})
    void aBmpThatContainsAnImageOfAnotherFormatIsRefused(int compression, String name) throws IOException {
        ByteBuffer bmp = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
        bmp.put(bytes('B', 'M')).putInt(60).putInt(0).putInt(54);
        bmp.putInt(40)
                .putInt(1)
                .putInt(1)
                .putShort((short) 1)
                .putShort((short) 24)
                .putInt(compression);
        Path file = Files.write(folder.resolve("e.bmp"), bmp.array());
        FloorPlanException e = assertThrows(FloorPlanException.class, () -> MapImageReader.read(file));
        assertEquals(file + ": the compression of the image is not supported: " + name, e.getMessage());
    }

    @Test
    void theScreenOfAGifIsExtendedToItsImage() throws IOException {
        MapImage map = MapImageReader.read(gif(0, 0, 0, 0));
        assertEquals(2, map.width());
        assertEquals(1, map.height());
        assertFalse(map.isTransparent(0, 0));
        assertEquals(5, MapImageReader.read(gif(4, 3, 3, 0)).width());
    }

    @Test
    void aGifWithATooLargeScreenIsRefused() throws IOException {
        Path file = gif(65535, 65535, 0, 0);
        FloorPlanException e = assertThrows(FloorPlanException.class, () -> MapImageReader.read(file));
        assertEquals(file + ": the image has 65535 x 65535 pixels; expected 1 to 64000000", e.getMessage());
    }
}
