package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.CharsetEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** File names derived from the names of scenarios. */
class FileNamesTest {

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            textBlock =
                    """
            A room, A room
            Pokój żółty 漢, Pokój żółty 漢
            `a/b\\c:d*e?f"g<h>i|j`, a_b_c_d_e_f_g_h_i_j
            `  ..room. `, room
            ``, scenario
            `. .`, scenario
            con, _con
            Lpt1.room, _Lpt1.room
            console, console
            COM¹, _COM¹
            lpt².room, _lpt².room
            Com³, _Com³
            COM⁴, COM⁴
            नमस्ते, नमस्ते
            Café, Café
            """)
    void aFileNameKeepsLettersAndNoCharacterThatASystemRejects(String scenario, String file) {
        assertEquals(file, FileNames.forScenario(scenario));
    }

    @Test
    void aLetterThatTheEncodingOfFileNamesLacksIsReplaced() {
        CharsetEncoder encoder = StandardCharsets.US_ASCII.newEncoder();
        assertEquals("_ab_ _", FileNames.forScenario("żab\uD840\uDC0B 漢", encoder::canEncode));
        assertEquals("___", FileNames.forScenario("Łóż", encoder::canEncode));
    }

    @Test
    void aLongNameOfManyBytesIsCutBetweenLetters() {
        assertEquals("漢".repeat(66), FileNames.forScenario("漢".repeat(120)));
        assertEquals("\uD840\uDC0B".repeat(50), FileNames.forScenario("\uD840\uDC0B".repeat(51)));
        assertEquals("ż".repeat(100), FileNames.forScenario("ż".repeat(101)));
    }

    @Test
    void aFileNameIsShortAndValidForEveryScenarioName() {
        Random random = new Random(3);
        for (int i = 0; i < 2000; i++) {
            String scenario = random.ints(random.nextInt(300), 0, Character.MAX_CODE_POINT + 1)
                    .filter(c -> c < 0xD800 || c > 0xDFFF)
                    .map(c -> random.nextBoolean() ? c & 0x7F : c)
                    .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                    .toString();
            String name = FileNames.forScenario(scenario);
            assertTrue(!name.isBlank() && name.codePointCount(0, name.length()) <= 101, name);
            assertTrue(name.getBytes(StandardCharsets.UTF_8).length <= 201, name);
            assertFalse(name.matches("(?s).*[\\x00-\\x1F/\\\\:*?\"<>|].*|[. ].*|.*[. ]"), name);
        }
    }
}
