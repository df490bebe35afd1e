package faultline.gui.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.text.ParseException;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalFormatterTest {

    private final Locale before = Locale.getDefault();

    @AfterEach
    void restoreLocale() {
        Locale.setDefault(before);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"1.25 | 1.25", "1,25 | 1.25", " 3 | 3", ".5 | 0.5", "2. | 2", "+4 | 4", "1e1 | 10", "5E-1 | 0.5"})
    void pointAndCommaAndExponentsAreTaken(String text, double value) throws ParseException {
        for (String country : new String[] {"en-US", "pl-PL", "de-CH"}) {
            Locale.setDefault(Locale.forLanguageTag(country));
            assertEquals(value, new DecimalFormatter("0.00##", 0.01, 100).stringToValue(text));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "x", "1.2.3", "1,2,3", "1 2", "0x10", "NaN", "Infinity", "1e", "1e3", "0", "101", "-1"})
    void whatIsNoNumberOrBeyondTheLimitsIsRefused(String text) {
        assertThrows(ParseException.class, () -> new DecimalFormatter("0.00##", 0.01, 100).stringToValue(text));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"10 | 10", "10.0 | 10", "10,00 | 10", "1e1 | 10", "-3 | -3"})
    void aPatternWithoutDecimalsTakesWholeNumbers(String text, double value) throws ParseException {
        assertEquals(value, new DecimalFormatter("0", -5, 100).stringToValue(text));
    }

    @ParameterizedTest
    @ValueSource(strings = {"10.6", "10,6", "0.5", "1e-1", "-3.0001", "10.00000000000000000001"})
    void aPatternWithoutDecimalsRefusesFractions(String text) {
        ParseException refused =
                assertThrows(ParseException.class, () -> new DecimalFormatter("0", -5, 100).stringToValue(text));
        assertEquals("whole numbers, -5 to 100", refused.getMessage());
    }

    @Test
    void numbersAreWrittenWithAPointInEveryCountry() {
        Locale.setDefault(Locale.forLanguageTag("pl-PL"));
        assertEquals("0.80", new DecimalFormatter("0.00##", 0, 1).valueToString(0.8));
        assertEquals("0.8125", new DecimalFormatter("0.00##", 0, 1).valueToString(0.8125));
    }

    @Test
    void limitsAreWrittenWithoutZerosAtTheEnd() {
        assertEquals("0.001 to 10000", new DecimalFormatter("0.00###", 0.001, 10000).limitsText());
        assertEquals("-0.05 to 0.6", new DecimalFormatter("0.00", -0.05, 0.6).limitsText());
    }
}
