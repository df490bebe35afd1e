package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class CommandWordsTest {

    @Test
    void blanksPartWordsAndQuotesKeepThem() {
        assertEquals(List.of("python3", "my.py"), CommandWords.split("  python3   my.py "));
        assertEquals(List.of("a b", "c d", ""), CommandWords.split("\"a b\" 'c d' ''"));
        assertEquals(List.of("a b"), CommandWords.split("a\\ b"));
        assertEquals(List.of(), CommandWords.split("  "));
    }

    @Test
    void backslashesOfWindowsPathsAreKept() {
        assertEquals(List.of("C:\\robots\\me.exe", "-x"), CommandWords.split("C:\\robots\\me.exe -x"));
    }

    @Test
    void quotesInsideQuotesNeedABackslash() {
        assertEquals(List.of("say \"hi\""), CommandWords.split("\"say \\\"hi\\\"\""));
        assertEquals(List.of("a\\b"), CommandWords.split("'a\\b'"));
    }

    @Test
    void anOpenQuoteIsReported() {
        assertThrows(IllegalArgumentException.class, () -> CommandWords.split("say \"hi"));
    }
}
