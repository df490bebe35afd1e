package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.util.List;
import org.junit.jupiter.api.Test;

class TextStyleTest {

    private static final TextStyle STYLE = TextStyle.plain(10, Color.BLACK);

    /** A letter such as n takes 6.2 pixels, a space 4.2. */
    @Test
    void aTextIsBrokenWhereTheNextWordDoesNotFit() {
        double threeWords = 6 * 6.2 + 2 * 4.2;
        assertEquals(threeWords, STYLE.estimateWidth("nn nn nn"), 1e-9);
        assertEquals(List.of("nn nn nn", "nn"), STYLE.wrap("nn  nn\nnn nn ", threeWords + 0.1));
        assertEquals(List.of("nn nn", "nn nn"), STYLE.wrap("nn nn nn nn", threeWords - 0.1));
    }

    @Test
    void aWordThatIsTooLongIsALineOfItsOwn() {
        assertEquals(List.of("n", "nnnnnnnn", "n"), STYLE.wrap("n nnnnnnnn n", 20));
    }

    @Test
    void boldLettersAreWiderAndNarrowOnesNarrower() {
        assertEquals(1.1 * STYLE.estimateWidth("n"), STYLE.withBold().estimateWidth("n"), 1e-9);
        assertEquals(3.2, STYLE.estimateWidth("i"), 1e-9);
        assertEquals(9, STYLE.estimateWidth("M"), 1e-9);
        assertEquals(9, STYLE.estimateWidth("m"), 1e-9);
        assertEquals(7.2, STYLE.estimateWidth("A"), 1e-9);
    }

    @Test
    void theUnderscoresOfALiteralTextAreDoubled() {
        assertEquals("a__b", TextStyle.literal("a_b"));
    }
}
