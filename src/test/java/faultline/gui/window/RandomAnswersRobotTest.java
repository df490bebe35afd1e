package faultline.gui.window;

import faultline.gui.EdtChecker;
import faultline.gui.theme.Theme;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Random answers to the dialogs of the window: Escape leaves them all, and the window keeps the focus and a run. It
 * ends after half a minute. A failure names its seed, which the system property {@code faultline.answers.seed} sets.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class RandomAnswersRobotTest {

    private static final long SEED = Long.getLong("faultline.answers.seed", 11);
    private static final int MAX_GESTURES = Integer.getInteger("faultline.answers", 40);
    private static final long MAX_NANOS = TimeUnit.SECONDS.toNanos(30);

    @TempDir
    private Path folder;

    @Test
    void escapeLeavesEveryDialog() throws IOException {
        Path file = Files.copy(Path.of("scenarios/three-visitors.xml"), folder.resolve("three-visitors.xml"));
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, file)) {
            driver.runFast(frame -> frame.snapshot().time() > 1);
            MonkeyTester user = new MonkeyTester(driver, SEED);
            int gestures = 0;
            long start = System.nanoTime();
            while (gestures < MAX_GESTURES && System.nanoTime() - start < MAX_NANOS) {
                user.performGestureAndAnswer();
                gestures++;
            }
            System.out.println(gestures + " gestures with random answers, seed " + SEED);
            driver.choose("restart");
            driver.waitForFrame(
                    "the start of the run", frame -> frame.snapshot().tick() == 0);
            driver.choose("step");
            driver.waitForFrame("one step", frame -> frame.snapshot().tick() == 1);
        }
    }
}
