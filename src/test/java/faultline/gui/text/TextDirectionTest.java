package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TextDirectionTest {

    private static final String HEBREW = "\u05e9\u05dc\u05d5\u05dd";

    @Test
    void aTextThatBeginsWithARightToLeftNameGetsAMark() {
        assertEquals("\u200e" + HEBREW + ".xml – Faultline", TextDirection.leftToRight(HEBREW + ".xml – Faultline"));
        assertEquals("\u200e7 " + HEBREW, TextDirection.leftToRight("7 " + HEBREW));
    }

    @Test
    void otherTextsAreUnchanged() {
        assertEquals("", TextDirection.leftToRight(""));
        assertEquals("stół.xml", TextDirection.leftToRight("stół.xml"));
        assertEquals("fault of " + HEBREW, TextDirection.leftToRight("fault of " + HEBREW));
    }
}
