package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The value of a coloured pixel is the mean of its red, green and blue, as the file stores them. */
class SampleValuesTest {

    @TempDir
    private Path folder;

    private static void assertValue(double expected, MapImage map, int column) {
        assertEquals(expected, map.sample(column, 0) * 255.0 / map.white(), 1e-9, "pixel " + column);
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff"})
    void coloursOf16BitsAreNotRounded(String format) throws IOException {
        ColorModel rgb = new ComponentColorModel(
                ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_USHORT);
        BufferedImage image = new BufferedImage(rgb, rgb.createCompatibleWritableRaster(2, 1), false, null);
        image.getRaster().setPixel(0, 0, new int[] {22950, 22950, 22950});
        image.getRaster().setPixel(1, 0, new int[] {65535, 65535, 65533});
        Path file = folder.resolve("colours");
        assertTrue(ImageIO.write(image, format, file.toFile()));
        MapImage map = MapImageReader.read(file);
        assertValue(22950 / 257.0, map, 0);
        assertValue((3 * 65535 - 2) / 3.0 / 257, map, 1);
    }

    @Test
    void aPartOfALargerImageKeepsValuesOfMoreThan16Bits() {
        MapImage part = new MapImage(1, 1, 3 * 65535);
        part.set(0, 100_000, false);
        assertEquals(100_000, part.on(2, 2, 1, 1).sample(1, 1));
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16})
    void aColourProfileChangesNoPixel(int bits) throws IOException {
        int unit = bits == 8 ? 1 : 257;
        Path file = new TiffFile(2, bits, bits, bits)
                .withProfile(ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData())
                .write(folder.resolve("p.tiff"), 87 * unit, 87 * unit, 87 * unit, 0, 40 * unit, 200 * unit);
        MapImage map = MapImageReader.read(file);
        assertValue(87, map, 0);
        assertValue(80, map, 1);
    }

    @Test
    void packedColoursAreScaled() throws IOException {
        Path file = new TiffFile(2, 5, 6, 5).write(folder.resolve("p.tiff"), 31, 63, 31, 0, 63, 0, 31, 0, 0);
        MapImage map = MapImageReader.read(file);
        assertValue(255, map, 0);
        assertValue(85, map, 1);
        assertValue(85, map, 2);
    }
}
