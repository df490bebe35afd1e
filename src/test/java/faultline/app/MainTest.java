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
}
