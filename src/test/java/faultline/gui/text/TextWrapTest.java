package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class TextWrapTest {

    @Test
    void aShortSentenceStaysAsItIs() {
        assertEquals("a short one.", TextWrap.wrap("a short one."));
        assertEquals("", TextWrap.wrap(""));
    }

    @Test
    void aLongSentenceIsBrokenBetweenWordsAndKeepsThemAll() {
        String sentence = "word and another ".repeat(30).strip();
        String broken = TextWrap.wrap(sentence);
        assertEquals(sentence, broken.replace('\n', ' '));
        assertTrue(broken.lines().allMatch(line -> line.length() <= 80), broken);
        assertTrue(broken.lines().count() <= 8, broken);
    }

    @Test
    void aLineHasUpToEightyCharacters() {
        String words = "abc ".repeat(19);
        assertEquals(words + "abcd", TextWrap.wrap(words + "abcd"));
        assertEquals(words.strip() + "\nabcde", TextWrap.wrap(words + "abcde"));
    }

    @Test
    void aWordWithoutEndIsCut() {
        assertEquals("x".repeat(80) + "\n" + "x".repeat(20), TextWrap.wrap("x".repeat(100)));
    }
}
