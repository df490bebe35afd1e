package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class JsonTest {

    @Test
    void valuesOfEveryKindAreRead() throws JsonException {
        assertEquals(
                Map.of("a", List.of(1.0, -0.5, 2e3), "b", true, "c", "x\n\u00e9\"", "d", Map.of(), "e", List.of()),
                JsonParser.parse(
                        " { \"a\" : [1, -0.5, 2e3], \"b\":true, \"c\":\"x\\n\\u00e9\\\"\", \"d\":{}, \"e\":[ ] } "));
        assertEquals(JsonParser.NULL, JsonParser.parse("null"));
        assertEquals(List.of(true, false, JsonParser.NULL, 1.0), JsonParser.parse("[true,false,null,1]"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            hello            | there is no value at character 1
            {"a":1           | a comma or } is missing at character 7
            {"a" 1}          | a colon is missing at character 6
            {a:1}            | a member's name is missing at character 2
            {"a":1,"a":2}    | a member is given twice at character 13
            [1,]             | there is no value at character 4
            [1 2]            | a comma or ] is missing at character 4
            01               | a number begins with a zero at character 3
            1.               | a digit is missing at character 3
            -                | a digit is missing at character 2
            "a               | the text ends too early at character 3
            "\\x"            | there is no such escape at character 4
            "\\u12g4"        | an escape needs four hexadecimal digits at character 6
            "\\u００４１"   | an escape needs four hexadecimal digits at character 4
            "\\u12           | the text ends too early at character 6
            -x               | a digit is missing at character 2
            1e+              | a digit is missing at character 4
            tru              | there is no value at character 1
            1 2              | there is text after the value at character 3
            NaN              | NaN is no number in JSON at character 1
            [1,Infinity]     | Infinity is no number in JSON at character 4
            -Infinity        | -Infinity is no number in JSON at character 2
            \uFEFF{}         | there is a byte order mark at character 1
            """)
    void aTextThatIsNoJsonIsReportedWithItsPlace(String text, String message) {
        String given = text.replace("\\\\", "\\");
        assertEquals(
                message,
                assertThrows(JsonException.class, () -> JsonParser.parse(given)).getMessage());
    }

    @Test
    void aWholeNumberThatADoubleWouldRoundIsExact() throws JsonException {
        assertEquals(9007199254740993L, JsonParser.parse("9007199254740993"));
        assertEquals(Long.MIN_VALUE, JsonParser.parse("-9223372036854775808"));
        assertEquals(
                "9223372036854775808", JsonParser.parse("9223372036854775808").toString());
        assertEquals(0x1p63, ((Number) JsonParser.parse("9223372036854775808")).doubleValue());
        assertEquals(9007199254740991.0, JsonParser.parse("9007199254740991"));
        assertEquals(0x1p53, JsonParser.parse("9007199254740992.0"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e999", "-1E+400", "1e99999999999"})
    void aNumberBeyondAllDoublesKeepsItsText(String text) throws JsonException {
        Number number = (Number) JsonParser.parse(text);
        assertEquals(text, number.toString());
        assertTrue(Double.isInfinite(number.doubleValue()));
    }

    @Test
    void everyEscapeIsReadAndAControlCharacterIsRefused() throws JsonException {
        assertEquals("\b\f\n\r\t/\\\"\u00e9", JsonParser.parse("\"\\b\\f\\n\\r\\t\\/\\\\\\\"\\u00E9\""));
        assertEquals(
                "a string holds a control character at character 4",
                assertThrows(JsonException.class, () -> JsonParser.parse("\"a\u0001\""))
                        .getMessage());
    }

    @Test
    void valuesAreNestedUpTo64Deep() throws JsonException {
        assertEquals(1, ((List<?>) JsonParser.parse("[".repeat(64) + "]".repeat(64))).size());
        assertEquals(
                "values are nested more than 64 deep at character 66",
                assertThrows(JsonException.class, () -> JsonParser.parse("[".repeat(65) + "]".repeat(65)))
                        .getMessage());
        assertEquals(2, ((List<?>) JsonParser.parse("[{\"a\":[" + "[],{},".repeat(65) + "[]]},0]")).size());
        assertEquals(131, ((List<?>) JsonParser.parse("[" + "[1],{\"a\":1},".repeat(65) + "0]")).size());
    }

    @Test
    void deepNestingIsRefusedAndNotOverflowing() {
        String deep = "[".repeat(100_000);
        assertThrows(JsonException.class, () -> JsonParser.parse(deep));
    }

    @Test
    void finiteNumbersReadBackToTheSameBits() throws JsonException {
        Random random = new Random(1);
        for (int i = 0; i < 100_000; i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(value)) {
                Map<?, ?> read = (Map<?, ?>)
                        JsonParser.parse(new JsonWriter().member("n", value).finish());
                assertEquals(Double.doubleToRawLongBits(value), Double.doubleToRawLongBits((Double) read.get("n")));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "plain", "quote \" and \\ slash", "line\nbreak\ttab\u0000", "\ud83d\ude00 \u2028"})
    void stringsReadBack(String text) throws JsonException {
        Map<?, ?> read =
                (Map<?, ?>) JsonParser.parse(new JsonWriter().member("s", text).finish());
        assertEquals(text, read.get("s"));
    }

    @Test
    void valuesOfEveryKindAreWritten() {
        JsonWriter json = new JsonWriter()
                .member("text", "a")
                .member("whole", 7L)
                .member("flag", true)
                .name("array")
                .beginArray()
                .value("b")
                .value(2.5)
                .value(false)
                .nullValue()
                .beginObject()
                .member("in", 1.0)
                .endObject()
                .beginArray()
                .endArray()
                .endArray()
                .name("empty")
                .beginObject()
                .endObject();
        assertEquals(
                "{\"text\":\"a\",\"whole\":7,\"flag\":true,"
                        + "\"array\":[\"b\",2.5,false,null,{\"in\":1},[]],\"empty\":{}}",
                json.finish());
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "-0.0, -0.0", "3, 3", "-2, -2", "0.5, 0.5", "999999999999999, 999999999999999", "1e15, 1.0E15"})
    void aWholeNumberIsWrittenWithoutAFraction(double value, String text) {
        assertEquals("{\"n\":" + text + "}", new JsonWriter().member("n", value).finish());
    }

    /** Before JDK 19, {@link Double#toString(double)} had a digit too many for some numbers. */
    @Test
    void aNumberHasTheShortestText() {
        assertEquals(
                "{\"n\":5.684341886080802E-14}",
                new JsonWriter().member("n", Math.scalb(1.0, -44)).finish());
    }

    @Test
    void aNumberThatJsonCannotWriteIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new JsonWriter().member("n", Double.NaN));
    }
}
