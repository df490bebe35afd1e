package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.RunFailedException;
import faultline.external.ControllerProblem;
import faultline.io.AtomicFile;
import faultline.io.Message;
import faultline.io.MessageException;
import faultline.io.WriteProblem;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.ScenarioException;
import java.awt.print.PrinterException;
import java.awt.print.PrinterIOException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.concurrent.CompletionException;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The descriptions of exceptions. */
class ErrorMessagesTest {

    @TempDir
    private Path folder;

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    static Stream<Arguments> printerExceptions() {
        return Stream.of(
                Arguments.of(
                        new PrinterIOException(new IOException(
                                "Cannot run program \"/usr/bin/lpr\": error=2, No such file or directory")),
                        "the program /usr/bin/lpr cannot be started; it may not be installed",
                        "nie można uruchomić programu /usr/bin/lpr; może nie jest zainstalowany"),
                Arguments.of(
                        new PrinterIOException(new IOException(
                                "Cannot run program \"lpr\": Exec failed," + " error: 2 (No such file or directory)")),
                        "the program lpr cannot be started; it may not be installed",
                        "nie można uruchomić programu lpr; może nie jest zainstalowany"),
                Arguments.of(
                        new PrinterIOException(
                                new IOException("Cannot run program \"lpr\": error=13, Permission denied")),
                        "Cannot run program \"lpr\": error=13, Permission denied",
                        "Cannot run program \"lpr\": error=13, Permission denied"),
                Arguments.of(
                        new PrinterIOException(new IOException("No such printer")),
                        "No such printer",
                        "No such printer"),
                Arguments.of(new PrinterException(), "the printer reports an error", "błąd drukarki"));
    }

    static Stream<Arguments> exceptions() {
        return Stream.of(
                Arguments.of(new OutOfMemoryError("Java heap space"), "not enough memory", "za mało pamięci"),
                Arguments.of(new AccessDeniedException("/x/y"), "access is denied", "brak dostępu"),
                Arguments.of(
                        new NoSuchFileException("/x/y"), "no such file or folder", "nie ma takiego pliku lub folderu"),
                Arguments.of(
                        new FileSystemException("/x/y"),
                        "the disk or network reports an error",
                        "błąd dysku lub sieci"),
                Arguments.of(
                        new FileSystemException("/x/y", null, "No space left on device"),
                        "No space left on device",
                        "No space left on device"),
                Arguments.of(
                        new NullPointerException(),
                        "internal error (NullPointerException)",
                        "błąd wewnętrzny (NullPointerException)"),
                Arguments.of(
                        new IllegalStateException("the wheel came off"), "the wheel came off", "the wheel came off"),
                Arguments.of(
                        new CompletionException(new UncheckedIOException(new AccessDeniedException("/x"))),
                        "access is denied",
                        "brak dostępu"),
                Arguments.of(
                        new MessageException("", WriteProblem.READ_ONLY.with(), null),
                        "writing to the file is not permitted",
                        "zapis do tego pliku nie jest dozwolony"),
                Arguments.of(
                        new MessageException("", ProblemKind.NOT_SAVED.with(ProblemKind.NOT_REPRODUCIBLE.with()), null),
                        "reading the saved file would give a different scenario",
                        "zapisany plik dałby po wczytaniu inny scenariusz"));
    }

    @ParameterizedTest
    @MethodSource({"exceptions", "printerExceptions"})
    void anExceptionIsAPhraseInTheUsersLanguage(Throwable why, String english, String polish) {
        assertEquals(english, ErrorMessages.describe(why));
        Messages.setLanguage(Language.POLISH);
        assertEquals(polish, ErrorMessages.describe(why));
    }

    @Test
    void theEndOfAControllerIsInTheUsersLanguage() {
        Message sentence = ControllerProblem.ENDED.with(
                ControllerProblem.CONTROLLER.with("python3 my.py"), ControllerProblem.AT_TICK.with(17), 1, "");
        RunFailedException why = new RunFailedException(sentence, null);
        assertEquals("the controller \"python3 my.py\" ended with exit code 1 at tick 17", ErrorMessages.describe(why));
        Messages.setLanguage(Language.POLISH);
        assertEquals("sterownik \"python3 my.py\" zakończył się w kroku 17 z kodem 1", ErrorMessages.describe(why));
    }

    @Test
    void aFileNameThatIsAlreadyShownIsOmitted() {
        IOException why = Assertions.assertThrows(
                IOException.class, () -> AtomicFile.create(folder).close());
        assertEquals("this is a folder; expected a file", ErrorMessages.describe(why, folder));
        Messages.setLanguage(Language.POLISH);
        assertEquals("to jest folder; dozwolone: plik", ErrorMessages.describe(why, folder));
    }

    @Test
    void theFirstProblemOfAFileIsReported() throws IOException {
        Path empty = Files.createFile(folder.resolve("empty.xml"));
        ScenarioException why = Assertions.assertThrows(ScenarioException.class, () -> Scenario.load(empty));
        assertEquals("the file is empty; expected a scenario", ErrorMessages.describe(why, empty));
    }

    @Test
    void aSentenceAboutAFileHasACapitalLetterUnlessItNamesAnotherFile() {
        Path map = Path.of("map.png");
        Message reason = WriteProblem.IS_FOLDER.with();
        String phrase = Messages.get(reason);
        assertEquals(
                ErrorMessages.capitalised(phrase),
                ErrorMessages.describeAsSentence(new MessageException("map.png", reason, null), map));
        assertEquals(
                "other.png: " + phrase,
                ErrorMessages.describeAsSentence(new MessageException("other.png", reason, null), map));
        assertEquals("This fails", ErrorMessages.describeAsSentence(new IOException("this fails"), map));
    }
}
