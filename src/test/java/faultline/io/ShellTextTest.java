package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ShellTextTest {

    @Test
    void aWordThatAShellTakesSoIsNotQuoted() {
        assertEquals("scenarios/yard.xml", ShellText.quotedForUnix("scenarios/yard.xml"));
        assertEquals("C:\\robots\\me.py", ShellText.quotedForWindows("C:\\robots\\me.py"));
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
