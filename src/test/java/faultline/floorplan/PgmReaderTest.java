package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PgmReaderTest {

    @TempDir
    Path folder;

    private MapImage read(String text) throws IOException {
        Path file = folder.resolve("map.pgm");
        Files.write(file, text.getBytes(StandardCharsets.ISO_8859_1));
        return MapImageReader.read(file);
    }

    @ParameterizedTest
    @CsvSource({"255, 1", "256, 2", "65535, 2"})
    void samplesAboveAByteTakeTwo(int max, int bytes) throws IOException {
        String pixels = bytes == 1 ? "\5\7" : "\0\5\0\7";
        MapImage image = read("P5 2 1 " + max + "\n" + pixels);
        assertEquals(5, image.sample(0, 0));
        assertEquals(7, image.sample(1, 0));
        assertEquals(max, image.white());
    }

    @Test
    void anImageMayHaveTwoLevels() throws IOException {
        MapImage image = read("P2 2 1 1 0 1");
        assertEquals(1, image.white());
        assertEquals(1, image.sample(1, 0));
    }

    /** Some editors add a line feed at the end of a file. */
    @Test
    void bytesAfterThePixelsDoNotMoveThem() throws IOException {
        for (String end : new String[] {"\n", "\r", " "}) {
            MapImage image = read("P5 2 1 255" + end + "\5\7\n");
            assertEquals(5, image.sample(0, 0));
            assertEquals(7, image.sample(1, 0));
        }
    }

    @Test
    void aHeaderBeforeSamplesOfTwoBytesMayEndWithTwoBytes() throws IOException {
        MapImage image = read("P5 2 1 65535\r\n\0\5\0\7");
        assertEquals(5, image.sample(0, 0));
        assertEquals(7, image.sample(1, 0));
    }

    @Test
    void theFirstOfTwoBytesIsTheMoreSignificant() throws IOException {
        assertEquals(0x0102, read("P5 1 1 65535\n\1\2").sample(0, 0));
    }

    @Test
    void theFirstPixelMayLookLikeABlank() throws IOException {
        assertEquals('\n', read("P5 1 1 255\n\n").sample(0, 0));
    }
}
