package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MessageTextTest {

    @ParameterizedTest
    @ValueSource(
            ints = {
                0, '\t', '\n', 0x1b, 0x7f, 0x9b, 0x061c, 0x200e, 0x200f, 0x2028, 0x2029, 0x202a, 0x202e, 0x2066, 0x2069,
                0xd800, 0xdfff
            })
    void aCharacterThatChangesHowTheRestIsShownBecomesABlank(int control) {
        String text = "a" + (char) control + "b";
        assertEquals("a b", MessageText.oneLine(text));
    }

    @ParameterizedTest
    @ValueSource(ints = {' ', 0xa0, 0x2027, 0x2030, 0x206a, 0x1f916})
    void otherCharactersStay(int letter) {
        String text = "a" + Character.toString(letter) + "b";
        assertEquals(text, MessageText.oneLine(text));
    }

    @Test
    void anExcerptHasSixtyCharacters() {
        assertEquals("x".repeat(60), MessageText.excerpt("x".repeat(60)));
        assertEquals("x".repeat(60) + "...", MessageText.excerpt("x".repeat(61)));
    }

    @Test
    void aCharacterOfTwoHalvesIsNotSplit() {
        String robot = Character.toString(0x1f916);
        assertEquals("x".repeat(59) + "...", MessageText.excerpt("x".repeat(59) + robot));
        assertEquals("x".repeat(58) + robot + "...", MessageText.excerpt("x".repeat(58) + robot + "x"));
        assertEquals("x", MessageText.start("x" + robot, 2));
        assertEquals("x" + robot, MessageText.start("x" + robot, 3));
    }

    @Test
    void theStartOfAShortTextIsTheText() {
        assertEquals("", MessageText.start("", 1));
        assertEquals("ab", MessageText.start("ab", 3));
    }

    @Test
    void aNameHasSingleBlanksAndNoneAtItsEnds() {
        assertEquals("my robot", MessageText.name(" my \n\t robot\u202e "));
        assertEquals("", MessageText.name(" \n"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    a b     | a b
                    a,b     | "a,b"
                    ,b      | ",b"
                    say "a" | "say ""a""\"
                    =1+1    | '=1+1
                    -1.5    | -1.5
                    -x      | '-x
                    @A1,2   | "'@A1,2"
                    """,
            quoteCharacter = '`')
    void aCellIsQuotedIfItNeedsItAndIsNoFormula(String text, String cell) {
        assertEquals(cell, MessageText.csvCell(text));
    }

    @Test
    void theControlCharactersOfACellBecomeBlanks() {
        assertEquals("\"a b c\"", MessageText.csvCell("a\nb\0c"));
        assertEquals("\"a b\"", MessageText.csvCell("a\u007fb"));
        assertEquals("\"a b,c\"", MessageText.csvCell("a\u0085b,c"));
        // An id may have a mark of the writing direction, and reports find its rows by it.
        assertEquals("a\u200eb", MessageText.csvCell("a\u200eb"));
    }

    @Test
    void theNameOfAConstantBecomesCamelCase() {
        assertEquals("tooDeep", MessageText.camelCase("TOO_DEEP"));
        assertEquals("full", MessageText.camelCase("FULL"));
    }
}
