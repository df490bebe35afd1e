package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FormatNoteTest {

    private static final String RUN = "run scenarios/struck-by-a-visitor.xml --until 0.1 ";

    @TempDir
    private Path folder;

    /** Runs a command that must succeed, and returns what it writes to standard error. */
    private String errors(String command) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        CommandOutput output = new CommandOutput(out, new PrintStream(err, true, StandardCharsets.UTF_8));
        String[] words = Stream.of(command.split(" "))
                .map(word -> word.replace("@", folder + "/"))
                .toArray(String[]::new);
        int code = new CommandLine(output).run(words);
        String text = err.toString(StandardCharsets.UTF_8).replace(folder + "/", "@");
        assertTrue(code < 2, text);
        return text;
    }

    private String start(String file) throws IOException {
        return new String(Files.readAllBytes(folder.resolve(file)), StandardCharsets.ISO_8859_1).substring(0, 6);
    }

    @ParameterizedTest
    @CsvSource({"x.jpg, jpg", "x.SVGZ, svgz", "x.gif, gif"})
    void aPictureOfWhichAnotherFormatIsExpectedIsNoted(String file, String ending) throws IOException {
        assertTrue(errors(RUN + "--image @" + file)
                .startsWith("@" + file + ": this is a PNG image, although the name ends with ." + ending
                        + "; names with the ending .png or .svg fit\n"));
        assertEquals("\u0089PNG\r\n", start(file));
    }

    @ParameterizedTest
    @CsvSource({"x.png, png", "x.MP4, mp4"})
    void aFilmOfWhichAnotherFormatIsExpectedIsNoted(String file, String ending) throws IOException {
        assertTrue(errors(RUN + "--film @" + file)
                .startsWith("@" + file + ": this is a GIF film, although the name ends with ." + ending
                        + "; names with the ending .gif fit\n"));
        assertEquals("GIF89a", start(file));
    }

    @Test
    void aComparisonOfWhichATableIsExpectedIsNoted() throws IOException {
        String command = "compare scenarios/office.xml --until 0.1 --controller none --controller wall-follower --out ";
        assertEquals(
                "@q.csv: this is an HTML page, although the name ends with .csv;"
                        + " names with the ending .html or .htm fit\n",
                errors(command + "@q.csv"));
        assertEquals("<!DOCT", start("q.csv").toUpperCase(Locale.ROOT));
        assertEquals("", errors(command + "@r.html"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--image @x.png", "--image @x.SVG", "--image @x", "--image @x.1", "--film @x.gif"})
    void otherNamesAreNotNoted(String option) {
        assertEquals(errors(RUN), errors(RUN + option));
    }

    @Test
    void aFolderIsNotNoted() {
        assertEquals(Optional.empty(), FormatNote.of(Path.of("/"), "a PNG image", List.of("png")));
    }
}
