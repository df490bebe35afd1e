package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tags of TIFF files that change the meaning of their samples. */
class TiffTagsTest {

    @TempDir
    private Path folder;

    private MapImage read(TiffFile tiff, int... samples) throws IOException {
        return MapImageReader.read(tiff.write(folder.resolve("t.tiff"), samples));
    }

    private void assertRefused(String reason, TiffFile tiff, int... samples) {
        IOException e = assertThrows(FloorPlanException.class, () -> read(tiff, samples));
        assertEquals(folder.resolve("t.tiff") + ": " + reason, e.getMessage());
    }

    /** Checks the values of pixels, 0 to 255. */
    private static void assertValues(MapImage map, int... expected) {
        int[] values = new int[map.width()];
        Arrays.setAll(values, x -> map.sample(x, 0) * 255 / map.white());
        assertEquals(Arrays.toString(expected), Arrays.toString(values));
    }

    /** Checks which pixels are transparent: {@code t} is, {@code o} is opaque. */
    private static void assertOpacity(String expected, MapImage map) {
        StringBuilder opacity = new StringBuilder();
        for (int x = 0; x < map.width(); x++) {
            opacity.append(map.isTransparent(x, 0) ? 't' : 'o');
        }
        assertEquals(expected, opacity.toString());
    }

    @ParameterizedTest
    @CsvSource({"0,3", "0,6", "0,12", "1,3", "1,6", "1,10", "1,12", "1,14", "3,6"})
    void aGreyOrAPaletteOfUnusualBitsIsRefused(int photometric, int bits) {
        TiffFile tiff = new TiffFile(photometric, bits);
        if (photometric == 3) {
            tiff.with(TiffFile.COLOR_MAP, new int[3 << bits]);
        }
        assertRefused("a pixel of the image has " + bits + " bits; expected 1, 2, 4, 8 or 16", tiff, 0, 1);
    }

    @ParameterizedTest
    @CsvSource({"2,3,12", "2,3,14", "2,5,4", "1,2,4", "1,3,12"})
    void samplesOfUnusualBitsAreRefused(int photometric, int samples, int bits) {
        TiffFile tiff = new TiffFile(
                photometric,
                Collections.nCopies(samples, bits).stream().mapToInt(b -> b).toArray());
        assertRefused(
                "the number of bits of a sample of the image is " + bits + "; expected 8 or 16",
                tiff,
                new int[samples]);
    }

    @Test
    void signedSamplesAreRefused() throws IOException {
        String reason = "the samples of the image are signed integers; expected unsigned ones";
        assertRefused(reason, new TiffFile(1, 8).with(TiffFile.SAMPLE_FORMAT, 2), 100);
        assertRefused(reason, new TiffFile(2, 8, 8, 8).with(TiffFile.SAMPLE_FORMAT, 1, 1, 2), 100, 100, 100);
        assertValues(read(new TiffFile(1, 8).with(TiffFile.SAMPLE_FORMAT, 1), 100), 100);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8, 16})
    void aGreyOfUsualBitsIsRead(int bits) throws IOException {
        int white = (1 << bits) - 1;
        assertValues(read(new TiffFile(1, bits), 0, white), 0, 255);
        assertValues(read(new TiffFile(0, bits), 0, white), 255, 0);
    }

    @Test
    void aFurtherSampleOfUnspecifiedTypeIsNoOpacity() throws IOException {
        MapImage grey = read(new TiffFile(1, 8, 8).with(TiffFile.EXTRA_SAMPLES, 0), 40, 0, 200, 255);
        assertValues(grey, 40, 200);
        assertOpacity("oo", grey);
        MapImage rgb = read(new TiffFile(2, 8, 8, 8, 8).with(TiffFile.EXTRA_SAMPLES, 0), 30, 40, 50, 0);
        assertValues(rgb, 40);
        assertOpacity("o", rgb);
        MapImage packed = read(new TiffFile(2, 4, 4, 4, 4).with(TiffFile.EXTRA_SAMPLES, 0), 15, 0, 0, 3);
        assertValues(packed, 85);
        assertOpacity("o", packed);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void theOpacityIsTheSampleOfItsType(int type) throws IOException {
        TiffFile grey = new TiffFile(1, 8, 8, 8).with(TiffFile.EXTRA_SAMPLES, 0, type);
        MapImage map = read(grey, 40, 0, 255, 90, 255, 100);
        assertValues(map, 40, 90);
        assertOpacity("ot", map);
        map = read(new TiffFile(2, 16, 16, 16, 16, 16).with(TiffFile.EXTRA_SAMPLES, type, 0), 0, 65535, 0, 65534, 0);
        assertValues(map, 85);
        assertOpacity("t", map);
    }

    @Test
    void aSingleFurtherSampleWithoutATypeIsTheOpacity() throws IOException {
        assertOpacity("ot", read(new TiffFile(1, 8, 8), 40, 255, 40, 254));
        assertOpacity("ot", read(new TiffFile(2, 8, 8, 8, 8), 1, 2, 3, 255, 1, 2, 3, 254));
        assertOpacity("o", read(new TiffFile(1, 8, 8, 8), 40, 0, 0));
    }

    @Test
    void aPaletteWithFurtherSamplesIsRefused() {
        TiffFile tiff = new TiffFile(3, 8, 8).with(TiffFile.COLOR_MAP, new int[3 << 8]);
        assertRefused("the image has a palette and 2 samples per pixel; expected 1", tiff, 0, 255);
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 5, 6, 8})
    void otherColoursThanGreyRgbAndPalettesAreRefused(int photometric) {
        String reason = "the photometric interpretation of the image is " + photometric
                + "; expected 0 to 3, which is grey, RGB or a palette";
        assertRefused(reason, new TiffFile(photometric, 8, 8, 8), 0, 0, 0);
        assertRefused(reason, new TiffFile(photometric, 8, 8, 8, 8), 0, 0, 0, 255);
    }

    @ParameterizedTest
    @ValueSource(ints = {6, 7})
    void jpegInATiffIsRefused(int compression) {
        assertRefused(
                "the compression of the image is not supported: JPEG",
                new TiffFile(1, 8).with(TiffFile.COMPRESSION, compression),
                0);
    }

    @Test
    void aFileWithoutAPhotometricInterpretationIsReadByItsSamples() throws IOException {
        assertValues(read(new TiffFile(1, 8).with(TiffFile.PHOTOMETRIC), 40), 40);
        MapImage rgb = read(new TiffFile(2, 8, 8, 8).with(TiffFile.PHOTOMETRIC), 30, 40, 50);
        assertValues(rgb, 40);
        assertFalse(rgb.isTransparent(0, 0));
        int[] map = new int[3 << 8];
        Arrays.fill(map, 40 * 257);
        assertValues(read(new TiffFile(3, 8).with(TiffFile.PHOTOMETRIC).with(TiffFile.COLOR_MAP, map), 7), 40);
    }
}
