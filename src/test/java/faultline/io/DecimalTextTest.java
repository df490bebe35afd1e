package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Decimal numbers and their text; the system property {@code faultline.numbers} sets how many are tried at random. */
class DecimalTextTest {

    private static final int NUMBERS = Integer.getInteger("faultline.numbers", 100_000) / 5;

    @ParameterizedTest
    @CsvSource({"0.004, 2, 0.00", "-0.004, 2, 0.00", "-0.0, 0, 0", "-0.006, 2, -0.01", "-10, 1, -10.0", "-0.4, 0, 0"})
    void aNumberThatIsRoundedToZeroHasNoSign(double value, int decimals, String text) {
        assertEquals(text, DecimalText.formatFixed(value, decimals));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, -0",
        "1, 1",
        "100, 100",
        "0.25, 0.25",
        "-3.5, -3.5",
        "1e-6, 0.000001",
        "100000, 100000",
        "1e14, 100000000000000",
        "1e15, 1E+15",
        "1e-16, 0.0000000000000001",
        "1e-17, 1E-17",
        "1e-20, 1E-20",
        "1e20, 1E+20"
    })
    void numbersAreWrittenPlainlyUnlessThatIsAbsurdlyLong(double value, String text) {
        assertEquals(text, DecimalText.format(value));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "1234.5, 1230", "0.0012345, 0.00123", "-9.996, -10"})
    void aRoundedNumberHasThreeDigits(double value, String text) {
        assertEquals(text, DecimalText.formatRounded(value));
    }

    @Test
    void aZeroKeepsItsSignAfterBlanks() {
        assertEquals(-0.0, DecimalText.toDouble(DecimalText.parse(" -0").orElseThrow(), " -0"));
        assertEquals(0.0, DecimalText.toDouble(DecimalText.parse(" 0").orElseThrow(), " 0"));
    }

    @Test
    void everyNumberReadsBackToTheSameBits() {
        Random random = new Random(1);
        for (int i = 0; i < NUMBERS; i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(value)) {
                String text = DecimalText.format(value);
                assertEquals(value, DecimalText.toDouble(DecimalText.parse(text).orElseThrow(), text), text);
            }
        }
    }

    @Test
    void numbersAreWrittenAsDecimalArithmeticWritesThem() {
        Random random = new Random(2);
        for (int i = 0; i < NUMBERS; i++) {
            double size = Math.pow(10, random.nextInt(14) - 5);
            double value = i % 2 == 0 ? size * random.nextGaussian() : Math.rint(size * random.nextInt(20)) / 20;
            if (value != 0) {
                String exact = new BigDecimal(Double.toString(value))
                        .stripTrailingZeros()
                        .toPlainString();
                assertEquals(exact, DecimalText.format(value));
            }
        }
    }

    @Test
    void everyAngleReadsBackToTheSameBits() {
        Random random = new Random(1);
        for (int i = 0; i < NUMBERS; i++) {
            double radians = random.nextGaussian() * Math.pow(10, random.nextInt(8) - 4);
            String text = DecimalText.formatDegrees(radians);
            assertEquals(radians, DecimalText.toRadians(DecimalText.parse(text).orElseThrow(), text), text);
        }
        assertEquals(-0.0, DecimalText.toRadians(DecimalText.parse("-0").orElseThrow(), "-0"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                " ",
                "abc",
                "1,5",
                "NaN",
                "Infinity",
                "INF",
                "0x10",
                "1d",
                "1f",
                "1e",
                "--1",
                "1 2",
                ".",
                "1e99999",
                "١"
            })
    void whatIsNoDecimalNumberIsNotRead(String text) {
        assertTrue(DecimalText.parse(text).isEmpty());
    }

    @ParameterizedTest
    @CsvSource({"5., 5", ".5, 0.5", "+5, 5", "' 5 ', 5", "1e3, 1000", "1E-2, 0.01"})
    void everyWayToWriteADecimalNumberIsRead(String text, double value) {
        assertEquals(value, DecimalText.parse(text).orElseThrow().doubleValue());
    }

    @Test
    void wholeNumbersHaveASignOrNone() {
        assertEquals(3, DecimalText.parseWhole(" +3 ").orElseThrow());
        assertEquals(
                Long.MIN_VALUE, DecimalText.parseWhole("-9223372036854775808").orElseThrow());
        for (String text : List.of("", "3.0", "1e3", "0x10", "1_000", "３", "9223372036854775808", "1 2", "+-1")) {
            assertTrue(DecimalText.parseWhole(text).isEmpty(), text);
        }
    }

    @Test
    void shortNumbersAreTheNearestDoubles() {
        Random random = new Random(5);
        int read = 0;
        for (int i = 0; i < 200_000; i++) {
            String digits = (random.nextInt(5) == 0 ? "0" : "")
                    + Long.toString(100_000_000_000_000L + (long) (8e14 * random.nextDouble()))
                            .substring(0, 1 + random.nextInt(14));
            int point = random.nextInt(digits.length() + 1);
            String text = (random.nextBoolean() ? "-" : "")
                    + digits.substring(0, point)
                    + (point == digits.length() ? "" : "." + digits.substring(point));
            double number = DecimalText.parseShort(text);
            if (!Double.isNaN(number)) {
                read++;
                assertEquals(Double.parseDouble(text), number, text);
                assertEquals(DecimalText.toDouble(DecimalText.parse(text).orElseThrow(), text), number, text);
            }
        }
        assertTrue(read > 140_000, read + " were read");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"", "-", ".", "-.", ".5", "+5", " 5", "5 ", "1e3", "1.2.3", "1234567890123456", "NaN", "\u0661"})
    void whatIsNoShortNumberIsLeftToTheExactReader(String text) {
        assertTrue(Double.isNaN(DecimalText.parseShort(text)));
    }

    @Test
    void aShortZeroKeepsItsSign() {
        assertEquals(-0.0, DecimalText.parseShort("-0.00"));
        assertEquals(0.0, DecimalText.parseShort("0"));
    }
}
