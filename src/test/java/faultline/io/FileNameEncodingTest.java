package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** In the locale of the tests; {@code CommandLineTest} has one without letters beyond ASCII. */
class FileNameEncodingTest {

    @ParameterizedTest
    @ValueSource(strings = {"room.xml", "m\u00f3j.xml", "\u017c\u00f3\u0142w.xml"})
    void theEncodingIsNamedForTheNamesThatAreNoPaths(String name) {
        Optional<String> expected = File.separatorChar == '/' && !isPath(name)
                ? Optional.of(System.getProperty("sun.jnu.encoding"))
                : Optional.empty();
        assertEquals(expected, FileNameEncoding.lacking(name));
    }

    private static boolean isPath(String name) {
        try {
            return !Path.of(name).toString().isEmpty();
        } catch (InvalidPathException e) {
            return false;
        }
    }
}
