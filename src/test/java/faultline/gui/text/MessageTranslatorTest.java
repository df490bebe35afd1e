package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The problems of files are translated completely. */
class MessageTranslatorTest {

    private static final Pattern ENGLISH =
            Pattern.compile("\\b(is|allowed|the|of|from|than|number|holds|has|one|or|and|metres|seconds)\\b");

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void anUnknownSentenceIsUnchanged() {
        assertEquals("the sky fell", MessageTranslator.translate("the sky fell"));
    }

    /**
     * The sentences of {@code ProblemsTest}, which holds one for each mistake that a file can have, and of
     * {@code HostileFilesTest}, which has those about whole files.
     */
    private static Stream<String> problemSentences() throws IOException {
        return Stream.concat(
                        sentences("ProblemsTest", "\\| *\\d+:\\d+: (\\S.+)"),
                        sentences(
                                "HostileFilesTest",
                                "\"(?:\\w+\\.xml[:\\d]*: )?((?:the|there|this|<world>) [^\"\\\\]+)\"[,;)]"))
                .distinct();
    }

    private static Stream<String> sentences(String test, String pattern) throws IOException {
        Pattern sentence = Pattern.compile(pattern);
        return Files.readAllLines(Path.of("src/test/java/faultline/scenario/xml", test + ".java")).stream()
                .map(sentence::matcher)
                .filter(Matcher::find)
                .map(found -> found.group(1).strip());
    }

    @Test
    void theSentencesAboutWholeFilesAreFound() throws IOException {
        assertTrue(
                problemSentences()
                        .toList()
                        .containsAll(List.of(
                                "there is no such file",
                                "the file has a DOCTYPE, allowed is none",
                                "<world> holds too much, allowed is 100000 obstacles and points together")),
                problemSentences().toList().toString());
    }

    @ParameterizedTest
    @MethodSource("problemSentences")
    void everyFileProblemIsTranslatedCompletely(String complaint) {
        assertEquals(complaint, MessageTranslator.translate(complaint), "in English as it is");
        Messages.setLanguage(Language.POLISH);
        String polish = MessageTranslator.translate(complaint);
        assertNotEquals(complaint, polish);
        String own = polish.replaceAll("\"[^\"]*\"|<[^>]*>", "");
        assertFalse(ENGLISH.matcher(own).find(), polish);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            kind of <fault> is "stick", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "stick", dozwolone: off, stuck; czy chodziło o "stuck"?
            width of <world> is "-6", allowed is a number from 0.000001 to 100000 metres | width w <world> to "-6", dozwolone: liczba od 0.000001 do 100000 (metry)
            kind of <fault> is "a", allowed is "b", allowed is off, stuck; did you mean "stuck"? | kind w <fault> to "a", allowed is "b", dozwolone: off, stuck; czy chodziło o "stuck"?
            name of <x> is "a number from 1 to 2", allowed is none | name w <x> to "a number from 1 to 2", dozwolone: brak
            <world> may not hold <text>, allowed is circle | <world> nie może zawierać <text>, dozwolone: circle
            this is not well-formed XML, after "<a", inside <world> of line 3 | to nie jest poprawny XML, za "<a", wewnątrz <world> z wiersza 3
            the scenario cannot be saved: it would not read back the same | nie można zapisać scenariusza: po wczytaniu byłby inny
            """)
    void aProblemIsTranslatedExceptForQuotedInput(String said, String polish) {
        Messages.setLanguage(Language.POLISH);
        assertEquals(polish, MessageTranslator.translate(said));
    }
}
