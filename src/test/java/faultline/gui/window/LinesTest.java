package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LinesTest {

    @Test
    void aShortSentenceStaysAsItIs() {
        assertEquals("a short one.", Lines.broken("a short one."));
        assertEquals("", Lines.broken(""));
    }

    @Test
    void aLongSentenceIsBrokenBetweenWordsAndKeepsThemAll() {
        String sentence = "word and another ".repeat(30).strip();
        String broken = Lines.broken(sentence);
        assertEquals(sentence, broken.replace('\n', ' '));
        assertTrue(broken.lines().allMatch(line -> line.length() <= 80), broken);
        assertTrue(broken.lines().count() <= 8, broken);
    }

    @Test
    void aWordWithoutEndIsCut() {
        assertEquals("x".repeat(80) + "\n" + "x".repeat(20), Lines.broken("x".repeat(100)));
    }
}
