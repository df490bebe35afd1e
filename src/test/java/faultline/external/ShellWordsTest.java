package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShellWordsTest {

    @Test
    void blanksPartWordsAndQuotesKeepThem() {
        assertEquals(List.of("python3", "my.py"), ShellWords.split("  python3   my.py "));
        assertEquals(List.of("a b", "c d", ""), ShellWords.split("\"a b\" 'c d' ''"));
        assertEquals(List.of("a b"), ShellWords.split("a\\ b"));
        assertEquals(List.of(), ShellWords.split("  "));
    }

    @Test
    void backslashesOfWindowsPathsAreKept() {
        assertEquals(List.of("C:\\robots\\me.exe", "-x"), ShellWords.split("C:\\robots\\me.exe -x"));
    }

    @Test
    void quotesInsideQuotesNeedABackslash() {
        assertEquals(List.of("say \"hi\""), ShellWords.split("\"say \\\"hi\\\"\""));
        assertEquals(List.of("a\\b"), ShellWords.split("'a\\b'"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "my follower.py",
                "C:\\my robots\\me.py",
                "\\\\server\\my robots\\me.py",
                "say \"hi\".py",
                "it's",
                "a\\",
                "a\\\\\"b",
                ""
            })
    void aQuotedWordStaysOneWord(String word) {
        assertEquals(List.of(word, "x"), ShellWords.split(ShellWords.quoted(word) + " x"));
    }

    @Test
    void aQuotedPathIsReadable() {
        assertEquals("\"C:\\my robots\\me.py\"", ShellWords.quoted("C:\\my robots\\me.py"));
    }

    @Test
    void anOpenQuoteIsReported() {
        assertThrows(IllegalArgumentException.class, () -> ShellWords.split("say \"hi"));
    }
}
