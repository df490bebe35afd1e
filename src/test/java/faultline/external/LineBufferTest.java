package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LineBufferTest {

    private static final int MAX_LENGTH = 1_000_000;

    private final LineBuffer lines = new LineBuffer();

    private void fill(byte[] bytes) throws IOException {
        ByteArrayInputStream in = new ByteArrayInputStream(bytes);
        while (in.available() > 0) {
            assertTrue(lines.fill(in));
        }
    }

    private void fill(String text) throws IOException {
        fill(text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void aLineIsThereWhenItsBreakHasArrived() throws Exception {
        fill("on");
        assertNull(lines.next());
        assertTrue(lines.hasPart());
        fill("e\ntwo\n");
        assertEquals("one", lines.next());
        assertEquals("two", lines.next());
        assertNull(lines.next());
        assertFalse(lines.hasPart());
    }

    @Test
    void aBreakMayHaveACarriageReturn() throws Exception {
        fill("one\r\n\r\n\n");
        assertEquals("one", lines.next());
        assertEquals("", lines.next());
        assertEquals("", lines.next());
    }

    @Test
    void aByteThatWasReadElsewhereIsPartOfTheLine() throws Exception {
        lines.add((byte) 'o');
        fill("ne\n");
        assertEquals("one", lines.next());
    }

    @Test
    void linesOfAnyLengthKeepTheirOrder() throws Exception {
        List<String> expected = new ArrayList<>();
        for (int length = 1; length < 100_000; length = 3 * length + 1) {
            expected.add("é".repeat(length));
            fill(expected.get(expected.size() - 1) + "\n" + "a");
            assertEquals(expected.get(expected.size() - 1), lines.next().replaceFirst("^a+", ""));
        }
    }

    @Test
    void whatIsLeftAtTheEndIsReturnedOnce() throws Exception {
        fill("one\ntw");
        assertEquals("one", lines.next());
        assertEquals("tw", lines.rest());
        assertNull(lines.rest());
    }

    @Test
    void aLineHasAtMostAMillionBytes() throws Exception {
        fill("x".repeat(MAX_LENGTH) + "\n" + "x".repeat(MAX_LENGTH + 1));
        assertEquals(MAX_LENGTH, lines.next().length());
        ProtocolException problem = assertThrows(ProtocolException.class, lines::next);
        assertEquals("wrote a line of more than 1000000 bytes; expected shorter ones", problem.getMessage());
    }

    @Test
    void bytesThatAreNotUtf8AreRefusedAndAReplacementCharacterIsNot() throws Exception {
        fill("\ufffd\n");
        assertEquals("\ufffd", lines.next());
        fill(new byte[] {'a', (byte) 0xff, '\n'});
        ProtocolException problem = assertThrows(ProtocolException.class, lines::next);
        assertEquals("wrote a line that is not UTF-8: \"a\ufffd\"", problem.getMessage());
    }
}
