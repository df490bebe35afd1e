package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LineReaderTest {

    @TempDir
    Path folder;

    @Test
    void linesComeWithTheirLineFeedsAndTheirLengthInBytes() throws IOException {
        Path file = Files.writeString(folder.resolve("a.csv"), "run\n\n\u00fc\na\0b\nend");
        try (LineReader in = new LineReader(file)) {
            assertEquals("run\n", in.next());
            assertEquals("\n", in.next());
            assertEquals("\u00fc\n", in.next());
            assertEquals(3, in.length());
            assertEquals("a\0b\n", in.next(), "a crash of the machine may leave zeros");
            assertEquals("end", in.next());
            assertEquals("", in.next());
            assertFalse(in.isTooLong());
        }
    }

    /** The last line contains the character that replaces wrong bytes. */
    @Test
    void aLineThatIsNotUtf8KeepsItsBytes() throws IOException {
        byte[] latin = {'M', (byte) 0xFC, 'l', '\n'};
        Path file = Files.write(folder.resolve("a.csv"), latin);
        Files.writeString(file, "\u00fc\uFFFD\n", StandardOpenOption.APPEND);
        try (LineReader in = new LineReader(file)) {
            assertEquals("M\uFFFDl\n", in.next());
            assertFalse(in.isText());
            assertArrayEquals(latin, in.bytes());
            in.next();
            assertTrue(in.isText());
        }
    }

    @Test
    void aLongLineComesInPiecesWithoutALineFeed() throws IOException {
        String line = "x".repeat(2 * LineReader.MAX_LENGTH);
        try (LineReader in = new LineReader(Files.writeString(folder.resolve("a.csv"), "run\n" + line + "\n"))) {
            assertEquals("run\n", in.next());
            String piece = in.next();
            assertTrue(in.isTooLong());
            assertTrue(line.startsWith(piece) && piece.length() < line.length());
            assertEquals(line + "\n", piece + in.next());
        }
    }

    @Test
    void aLineOfTheMaximumLengthWithItsLineFeedIsNotTooLong() throws IOException {
        String longest = "x".repeat(LineReader.MAX_LENGTH - 1) + "\n";
        try (LineReader in = new LineReader(Files.writeString(folder.resolve("a.csv"), longest + "x" + longest))) {
            assertEquals(longest, in.next());
            assertFalse(in.isTooLong());
            in.next();
            assertTrue(in.isTooLong());
        }
    }

    /** The block was written again after the crash, or before it out of order. */
    @Test
    void zerosOfACrashEndWithTheFileOrABlock() throws IOException {
        String line = "run\n0,lo";
        assertTrue(hasZerosOfCrash(line + "\0\0"));
        assertTrue(hasZerosOfCrash(line + "\0".repeat(3 * LineReader.MAX_LENGTH)));
        assertTrue(hasZerosOfCrash(line + "\0".repeat(512 - line.length()) + "st\n1,lo\0st\n"));
        assertTrue(hasZerosOfCrash(line + "\0".repeat((1 << 22) - line.length()) + "\n"));
        assertFalse(hasZerosOfCrash(line + "\0\n"));
        assertFalse(hasZerosOfCrash(line + "\0".repeat(511 - line.length()) + "st\n"));
        assertFalse(hasZerosOfCrash(line + "st\n"));
    }

    private boolean hasZerosOfCrash(String text) throws IOException {
        try (LineReader in = new LineReader(Files.writeString(folder.resolve("a.csv"), text))) {
            in.next();
            in.next();
            return in.hasZerosOfCrash();
        }
    }

    @Test
    void whatMayHaveNoEndIsRefused() {
        Path device = Path.of("/dev/zero");
        assumeTrue(Files.exists(device));
        IOException refusal = assertThrows(IOException.class, () -> new LineReader(device).close());
        assertEquals("/dev/zero: this is not a regular file; expected a table", refusal.getMessage());
    }
}
