package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.app.Main;
import faultline.scenario.ManyObstacles;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.io.TempDir;

/** The window shows a scenario near the limits of the format after a few seconds of processor time. */
@DisabledIf(value = "java.awt.GraphicsEnvironment#isHeadless", disabledReason = "there is no display")
class ManyObstaclesRobotTest {

    /** It takes 6.6 to 8.6 s on a machine that other work keeps busy. */
    private static final double MAX_SECONDS = 14;

    @TempDir
    private Path folder;

    /** Shows a file until the first picture, and prints the processor time of the whole process at its end. */
    static final class FirstPicture {

        private FirstPicture() {}

        public static void main(String[] arguments) {
            PrintStream out = System.out;
            Runtime.getRuntime()
                    .addShutdownHook(new Thread(() -> out.println(ProcessHandle.current()
                            .info()
                            .totalCpuDuration()
                            .orElse(Duration.ZERO)
                            .toMillis())));
            Main.main(arguments);
        }
    }

    @Test
    void theFirstPictureTakesAFewSecondsOfProcessorTime() throws Exception {
        Path file = Files.writeString(folder.resolve("many.xml"), ManyObstacles.text());
        Process process = JavaProcess.longBuilder(
                        FirstPicture.class.getName(), List.of("--startup-time", file.toString()))
                .start();
        List<String> lines = JavaProcess.output(process).lines().toList();
        assertEquals(0, process.waitFor());
        assertTrue(lines.get(0).matches("startup_s: \\d+\\.\\d\\d"), lines.toString());
        double seconds = Long.parseLong(lines.get(1)) / 1000.0;
        System.out.println(lines.get(0) + ", processor_s: " + seconds);
        assertTrue(seconds > 0 && seconds < MAX_SECONDS, seconds + " s");
    }
}
