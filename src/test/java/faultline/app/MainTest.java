package faultline.app;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class MainTest {

    /** A display that is configured may not answer. */
    @Test
    void commandsThatWritePicturesNeedNoDisplay() {
        assertTrue(Main.paintsWithoutWindow("run", "a.xml", "--image", "a.png"));
        assertTrue(Main.paintsWithoutWindow("compare", "a.xml"));
        assertTrue(Main.paintsWithoutWindow("figures", "--out", "figures"));
        assertFalse(Main.paintsWithoutWindow("compare", "a.xml", "--open"));
        assertFalse(Main.paintsWithoutWindow("a.xml"));
        assertFalse(Main.paintsWithoutWindow());
    }

    /** Other commands end the process, also if a thread is left. */
    @Test
    void theProcessOfAWindowContinuesUntilTheWindowIsClosed() {
        assertTrue(CommandLine.mayOpenWindow());
        assertTrue(CommandLine.mayOpenWindow("a.xml", "--play"));
        assertTrue(CommandLine.mayOpenWindow("--window"));
        assertTrue(CommandLine.mayOpenWindow("--startup-time", "a.xml"));
        assertTrue(CommandLine.mayOpenWindow("compare", "a.xml", "--open"));
        assertFalse(CommandLine.mayOpenWindow("compare", "a.xml"));
        assertFalse(CommandLine.mayOpenWindow("run", "a.xml"));
        assertFalse(CommandLine.mayOpenWindow("help", "run"));
        assertFalse(CommandLine.mayOpenWindow("--version"));
    }
}
