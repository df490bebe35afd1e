package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Canvas;
import java.awt.Font;
import java.awt.FontMetrics;
import java.util.List;
import java.util.stream.Stream;
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

    @Test
    void theLinesOfATextAreNotWiderThanAllowedAndKeepItsLineBreaks() {
        FontMetrics metrics = new Canvas().getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        assertEquals(List.of("one", "", "two"), TextWrap.lines("one\n\ntwo", metrics, 400));
        assertEquals(List.of(), TextWrap.lines("", metrics, 400));
        String words = "zażółć gęślą jaźń ".repeat(20).strip();
        List<String> lines = TextWrap.lines(words, metrics, 400);
        assertEquals(words, String.join(" ", lines));
        List<String> letters = TextWrap.lines("x".repeat(200), metrics, 400);
        assertEquals("x".repeat(200), String.join("", letters));
        for (String line : Stream.concat(lines.stream(), letters.stream()).toList()) {
            assertTrue(metrics.stringWidth(line) <= 400, line);
        }
        assertTrue(lines.size() > 3 && letters.size() > 1);
    }
}
