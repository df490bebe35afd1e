package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.CpuTime;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ValueSyntaxTest {

    private static List<String> texts(String syntax, double uniform) {
        return ValueSyntax.parse(syntax, "stream", false).orElseThrow().stream()
                .map(value -> value.text((stream, block) -> uniform, 0))
                .toList();
    }

    @Test
    void aListHasOneLevelForEachValue() {
        assertEquals(List.of("5", "10", "20"), texts(" 5 10  20 ", 0));
        assertEquals(List.of("left", "right"), texts("left right", 0));
    }

    @Test
    void aValueThatIsThereTwiceIsOneLevel() {
        assertEquals(List.of("0.2", "0.3"), texts("0.2 0.20 0.3 2e-1 0.3", 0));
        assertEquals(List.of("off", "1"), texts("off 1 off 1.0", 0));
        assertEquals(2, ValueSyntax.parse("1 01", "stream", true).orElseThrow().size(), "ids of two sensors");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '\'',
            textBlock =
                    """
                    "front nose", front nose
                    left "front nose" left "a..b" "any", left|front nose|a..b|any
                    any of "front nose" left, front nose
                    any of, any|of
                    left right left, left|right
                    """)
    void anIdWithBlanksStandsInQuotes(String text, String ids) {
        assertEquals(ids, firstTexts(text));
    }

    /** Returns the ids of a text, of a random choice the first one. */
    private static String firstTexts(String text) {
        return ValueSyntax.parseIds(text, "stream").orElseThrow().stream()
                .map(value -> value.text((stream, block) -> 0, 0))
                .collect(Collectors.joining("|"));
    }

    @ParameterizedTest
    @CsvSource({"1..3/3, 1|2|3", "any of left right, left", "1..3, 1"})
    void idsWithoutQuotesHaveTheFormsOfOtherValues(String text, String ids) {
        assertEquals(ids, firstTexts(text));
        assertEquals(Optional.empty(), ValueSyntax.parseIds("", "stream"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\"front nose", "front\"nose\"", "\"front\"nose", "\"\"", "any of \"front", "\""})
    void quotesAreInPairsAroundWholeIds(String text) {
        assertEquals(Optional.empty(), ValueSyntax.parseIds(text, "stream"));
    }

    @Test
    void idsInQuotesAreNoMoreThanOtherValues() {
        String most = "left ".repeat(ValueSyntax.MAX_VALUES - 1) + "\"front nose\"";
        assertEquals(2, ValueSyntax.parseIds(most, "stream").orElseThrow().size());
        assertEquals(Optional.empty(), ValueSyntax.parseIds(most + " left", "stream"));
    }

    @Test
    void aGridIsEvenlySpacedAndHasBothBounds() {
        assertEquals(List.of("0.1", "0.2", "0.3", "0.4"), texts("0.1..0.4/4", 0));
        assertEquals(List.of("-1", "0", "1"), texts("-1..1/3", 0));
        assertEquals(List.of("0", "0.333333333333", "0.666666666667", "1"), texts("0..1/4", 0), "twelve digits");
    }

    /** The dialog of a batch counts at each key that is typed. */
    @Test
    void theValuesOfAGridAreCountedWithoutMakingThem() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        // The first count also loads classes.
        assertEquals(OptionalInt.of(2), ValueSyntax.count("0..1/2"));
        long before = threads.getCurrentThreadAllocatedBytes();
        assertEquals(OptionalInt.of(100_000), ValueSyntax.count("0..1/100000"));
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(bytes < 100_000, bytes + " bytes for 100 000 values");
    }

    @ParameterizedTest
    @CsvSource({
        "18..90, 90",
        "' 5 10 7.5 ', 10",
        "1..3/2, 3",
        "any of 4 left 2, 4",
        "-3, -3",
        "1e400, Infinity",
        "left, NaN",
        "'', NaN",
        "9..1, NaN",
        "1..2/, NaN"
    })
    void theGreatestNumberIsThatOfAnyRun(String text, double expected) {
        assertEquals(expected, ValueSyntax.greatest(text).orElse(Double.NaN));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "any of "})
    void aListHasAtMostAHundredThousandValues(String form) {
        assertTrue(ValueSyntax.count(form + "5 ".repeat(100_000)).isPresent());
        assertEquals(OptionalInt.empty(), ValueSyntax.count(form + "5 ".repeat(100_001)));
    }

    @Test
    void anIntervalIsDrawnFrom() {
        assertEquals(List.of("0.1"), texts("0.1..0.4", 0));
        assertEquals(List.of("0.25"), texts("0.1..0.4", 0.5));
        assertEquals(List.of("0.4"), texts("0.1..0.4", Math.nextDown(1.0)));
        assertEquals(List.of("0.133367"), texts("0.1..0.4", 0.111222333), "six digits are enough");
        assertEquals(List.of("1.2345612"), texts("1.2345612..1.2345698", 0), "rounded to 1.23456");
        assertEquals(List.of("1.2345698"), texts("1.2345612..1.2345698", Math.nextDown(1.0)), "rounded to 1.23457");
    }

    @Test
    void aChoiceIsDrawnFrom() {
        assertEquals(List.of("off"), texts("any of off stuck", 0.49));
        assertEquals(List.of("stuck"), texts("any of off stuck", 0.5));
    }

    /** The check of the attribute then repeats the bound as it was written. */
    @ParameterizedTest
    @CsvSource({"0..1e999, 1e999", "0..1e999/3, 1e999", "-1e400..1, -1e400", "-1e999..1e999/5, -1e999"})
    void aBoundBeyondAllDoublesIsTheOnlyValue(String syntax, String bound) {
        assertEquals(List.of(bound), texts(syntax, 0.5));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "4..1", "1..1", "a..b", "a..2", "1..b", "1..2/1", "1..", "..2", "1..2 3"})
    void aTextThatIsNoValueIsRefused(String syntax) {
        assertEquals(Optional.empty(), ValueSyntax.parse(syntax, "stream", false));
    }

    @ParameterizedTest
    @CsvSource({
        "0.8..0.2, true",
        "' 4..1/3 ', true",
        "1..1, true",
        "1..2, false",
        "a..2, false",
        "3..b, false",
        "3.., false",
        "3 1, false"
    })
    void aRangeIsReversedUnlessItsFirstNumberIsTheSmallerOne(String text, boolean reversed) {
        assertEquals(reversed, ValueSyntax.isReversedRange(text));
    }

    private static Stream<String> longTexts() {
        return Stream.of("1..".repeat(20_000) + "/x", "any of" + " ".repeat(80_000) + "a\nb");
    }

    @ParameterizedTest
    @MethodSource("longTexts")
    void aLongTextIsJudgedInLinearTime(String syntax) {
        CpuTime time = CpuTime.start();
        ValueSyntax.parse(syntax, "stream", false);
        time.assertBelow(1);
    }

    @Test
    void aLongListInAnotherNotationIsRefused() {
        assertEquals(Optional.empty(), ValueSyntax.parse("1" + ",1".repeat(100_000), "stream", false));
    }
}
