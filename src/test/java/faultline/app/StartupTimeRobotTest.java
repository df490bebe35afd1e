package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The time until a file shows, and files that cannot be shown. */
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "opens a window, which needs a display")
class StartupTimeRobotTest {

    @TempDir
    private Path folder;

    private record Measured(int code, String output) {}

    private static Measured measure(Path file) throws IOException, InterruptedException {
        Process process = JavaProcess.builder(Main.class.getName(), List.of("--startup-time", file.toString()))
                .redirectErrorStream(true)
                .start();
        String output = JavaProcess.output(process);
        return new Measured(process.waitFor(), output);
    }

    @Test
    void theTimeOfAFileIsPrinted() throws Exception {
        Measured measured = measure(Path.of("scenarios/yard.xml"));
        assertTrue(measured.output.matches("startup_s: \\d+\\.\\d\\d\\R"), measured.output);
        assertEquals(0, measured.code);
    }

    @Test
    void aMissingFileIsReported() throws Exception {
        Path gone = folder.resolve("gone.xml");
        assertEquals(new Measured(2, gone + ": there is no such file" + System.lineSeparator()), measure(gone));
    }

    /** The window is made while a large file is read. */
    @Test
    void theProblemOfALargeFileIsReported() throws Exception {
        Path large = Files.writeString(folder.resolve("large.xml"), " ".repeat(2 << 20) + "<scenario/>");
        Measured measured = measure(large);
        assertTrue(measured.output.startsWith(large + ":1:"), measured.output);
        assertEquals(2, measured.code);
    }
}
