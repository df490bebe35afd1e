package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.gui.GuiLauncher;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.swing.Timer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;

/** The process ends with its window, and does not wait until AWT finds that nothing is left. */
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ExitRobotTest {

    private static final long DEADLINE_SECONDS = 120;

    /** Closes the window after its first frame, and keeps AWT busy, which alone would keep the process alive. */
    static final class BusyWindow {

        private BusyWindow() {}

        public static void main(String[] args) {
            GuiLauncher.openUntilFirstPaint(() -> new Timer(100, event -> {}).start());
        }
    }

    @Test
    void theProcessEndsWithItsWindow() throws IOException, InterruptedException {
        Process process = JavaProcess.start(BusyWindow.class.getName(), List.of());
        try {
            assertTrue(process.waitFor(DEADLINE_SECONDS, TimeUnit.SECONDS), "the process is alive");
            assertEquals(0, process.exitValue());
        } finally {
            process.destroyForcibly();
        }
    }
}
