package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.text.Language;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Dimension;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Components beside each other do not overlap: Swing paints those of most containers as if they did not, so that one
 * that is painted again covers the others until they are painted, too.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class OverlapRobotTest {

    @ParameterizedTest
    @CsvSource({"1500, 950, NORMAL, ENGLISH", "1366, 768, LARGEST, POLISH", "800, 600, NORMAL, ENGLISH"})
    void noComponentCoversAnother(int width, int height, TextSize size, Language language) {
        WindowDriver.installChoices(language, size);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/every-fault.xml"))) {
            runOnEdt(() -> {
                driver.window().setMinimumSize(new Dimension(200, 200));
                driver.window().setSize(width, height);
            });
            driver.robot()
                    .waitFor("the window has its size", () -> driver.window().getWidth() == width);
            driver.visitTabs(title -> assertEquals(List.of(), callOnEdt(() -> overlaps(driver.window())), title));
        }
    }

    private static List<String> overlaps(Component window) {
        return ComponentFinder.findAll(window, JComponent.class)
                .filter(container -> container.isShowing() && container.isOptimizedDrawingEnabled())
                .flatMap(OverlapRobotTest::overlapsIn)
                .toList();
    }

    private static Stream<String> overlapsIn(JComponent container) {
        List<Component> shown = Stream.of(container.getComponents())
                .filter(Component::isVisible)
                .toList();
        return IntStream.range(0, shown.size()).boxed().flatMap(i -> shown.subList(0, i).stream()
                .filter(other -> other.getBounds().intersects(shown.get(i).getBounds()))
                .map(other -> container.getClass().getSimpleName() + ": " + other + " and " + shown.get(i)));
    }
}
