package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShellTextTest {

    @Test
    void aWordThatAShellTakesSoIsNotQuoted() {
        assertEquals("scenarios/yard.xml", ShellText.quotedForUnix("scenarios/yard.xml"));
        assertEquals("C:\\robots\\me.py", ShellText.quotedForWindows("C:\\robots\\me.py"));
    }

    /** An interactive shell replaces the exclamation mark by an earlier command, even in double quotes. */
    @ParameterizedTest
    @ValueSource(strings = {"$HOME x", "`x` y", "a \"b\" c", "back\\ slash", "stop here!"})
    void whatAShellReplacesInDoubleQuotesIsInSingleOnes(String word) {
        assertEquals("'" + word + "'", ShellText.quotedForUnix(word));
    }

    @Test
    void aSingleQuoteIsInDoubleOnesOrOutsideOfSingleOnes() {
        assertEquals("\"it's here\"", ShellText.quotedForUnix("it's here"));
        assertEquals("'it'\\''s here!'", ShellText.quotedForUnix("it's here!"));
    }

    @Test
    void thePromptOfWindowsKnowsNoSingleQuotes() {
        assertEquals("'C:\\my robots\\me.py'", ShellText.quotedForUnix("C:\\my robots\\me.py"));
        assertEquals("\"C:\\my robots\\me.py\"", ShellText.quotedForWindows("C:\\my robots\\me.py"));
        assertEquals("\"it's\"", ShellText.quotedForWindows("it's"));
        assertEquals("\"\"", ShellText.quotedForWindows(""));
    }

    @Test
    void onWindowsABackslashIsDoubledOnlyBeforeAQuote() {
        assertEquals("\"py \\\"my robot.py\\\"\"", ShellText.quotedForWindows("py \"my robot.py\""));
        assertEquals("\"C:\\my robots\\\\\"", ShellText.quotedForWindows("C:\\my robots\\"));
        assertEquals("\"a \\\\\\\"\"", ShellText.quotedForWindows("a \\\""));
    }
}
