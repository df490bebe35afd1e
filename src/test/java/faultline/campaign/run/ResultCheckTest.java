package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ResultCheckTest {

    @Test
    void sixteenHexadecimalDigitsAreAHash() {
        assertTrue(ResultCheck.isHash("0123456789abcdef"));
    }

    /** Runs without a hash are no repetitions of each other. */
    @ParameterizedTest
    @ValueSource(strings = {"", "NA", "nan", "none", "0", "0123456789abcde", "0123456789abcdeg"})
    void otherTextsAreNone(String text) {
        assertFalse(ResultCheck.isHash(text));
    }
}
