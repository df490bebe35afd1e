package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.bar.ObstaclePalette;
import faultline.gui.bar.ToolBar;
import faultline.gui.form.NumberSpinner;
import faultline.gui.panel.ControlPanel;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.LaneView;
import faultline.gui.timeline.TimeBar;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** On small screens and with large text, the canvas keeps half of the window, and everything can be reached. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class LayoutRobotTest {

    /** Heights of the smallest rows of lanes and of their ruler, at the normal text size. */
    private static final int ROW = 12;

    private static final int RULER = 14;

    /**
     * The least height of a chart that shows, with its axes and the names of the states; 60 of it are for the lines.
     */
    private static final int MIN_CHART = 100;

    private static Stream<Arguments> screens() {
        return Stream.of(new Dimension(800, 600), new Dimension(1366, 768))
                .flatMap(screen -> Stream.of(TextSize.NORMAL, TextSize.LARGEST)
                        .flatMap(size -> Stream.of(Language.values())
                                .map(language -> Arguments.of(screen.width, screen.height, size, language))));
    }

    @ParameterizedTest
    @MethodSource("screens")
    void theCanvasKeepsHalfOfTheWindow(int width, int height, TextSize size, Language language) {
        WindowDriver.installChoices(language, size);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"))) {
            runOnEdt(() -> {
                driver.window().setMinimumSize(new Dimension(200, 200));
                driver.window().setSize(width, height);
            });
            driver.robot()
                    .waitFor("the window has its size", () -> driver.window().getWidth() == width);
            driver.robot().waitForPaint();
            Component root = driver.window().getRootPane();
            Dimension canvas = callOnEdt(() -> driver.canvas().getSize());
            assertTrue(2 * canvas.width >= root.getWidth(), canvas + " in " + root.getSize());
            assertTrue(2 * canvas.height >= root.getHeight(), canvas + " in " + root.getSize());
            Rectangle lanes = callOnEdt(() -> ComponentFinder.findAll(driver.window(), LaneView.class)
                    .findFirst()
                    .orElseThrow()
                    .getVisibleRect());
            int rows = height < 768 ? 2 : 5;
            assertTrue(lanes.height >= TextSize.scaled(RULER + rows * ROW), "lanes " + lanes);
            Component chart = ComponentFinder.find(driver.window(), JComponent.class, Messages.get("strip.view"));
            int chartHeight = callOnEdt(chart::getHeight);
            assertTrue(!chart.isShowing() || chartHeight >= TextSize.scaled(MIN_CHART), "chart " + chartHeight);
            List<AbstractButton> hidden = callOnEdt(() -> ComponentFinder.findAll(driver.window(), ToolBar.class)
                    .flatMap(bar -> ComponentFinder.findAll(bar, AbstractButton.class))
                    .filter(button -> !button.getVisibleRect().getSize().equals(button.getSize()))
                    .toList());
            assertTrue(hidden.isEmpty(), hidden.toString());
            assertFalse(scrollsSideways(driver), "the control panel scrolls sideways");
        }
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void theSmallestScreenShowsAllToolsAndTheFieldWithTheFocus(Language language) {
        WindowDriver.installChoices(language, TextSize.LARGEST);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"))) {
            runOnEdt(() -> {
                driver.window().setMinimumSize(new Dimension(200, 200));
                driver.window().setSize(640, 480);
            });
            driver.robot()
                    .waitFor("the window has its size", () -> driver.window().getHeight() == 480);
            driver.robot().waitForPaint();
            List<AbstractButton> hidden =
                    callOnEdt(() -> ComponentFinder.findAll(driver.window(), ObstaclePalette.class)
                            .flatMap(palette -> ComponentFinder.findAll(palette, AbstractButton.class))
                            .filter(button -> !button.getVisibleRect().getSize().equals(button.getSize()))
                            .toList());
            assertTrue(hidden.isEmpty(), hidden.toString());
            ControlPanel panel = callOnEdt(() -> ComponentFinder.findAll(driver.window(), ControlPanel.class)
                    .findFirst()
                    .orElseThrow());
            runOnEdt(() -> ComponentFinder.findAll(panel, JTabbedPane.class).forEach(tabs -> tabs.setSelectedIndex(1)));
            JTextField last = callOnEdt(() -> ComponentFinder.findAll(panel, NumberSpinner.class)
                    .filter(Component::isShowing)
                    .reduce((earlier, later) -> later)
                    .orElseThrow()
                    .textField());
            assertEquals(0, callOnEdt(() -> last.getVisibleRect().height));
            runOnEdt(last::requestFocusInWindow);
            driver.robot().waitFor("the last field shows", () -> last.getVisibleRect().height == last.getHeight());
        }
    }

    private static Stream<Arguments> smallScreens() {
        return Stream.of(new Dimension(640, 480), new Dimension(800, 600))
                .flatMap(screen -> Stream.of(TextSize.NORMAL, TextSize.LARGEST)
                        .map(size -> Arguments.of(screen.width, screen.height, size)));
    }

    @ParameterizedTest
    @MethodSource("smallScreens")
    void aSmallScreenShowsTheChartAndTheCanvasOnRequest(int width, int height, TextSize size) {
        WindowDriver.installChoices(Language.ENGLISH, size);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"))) {
            runOnEdt(() -> {
                driver.window().setMinimumSize(new Dimension(200, 200));
                driver.window().setSize(width, height);
            });
            Component chart = ComponentFinder.find(driver.window(), JComponent.class, Messages.get("strip.view"));
            driver.robot()
                    .waitFor(
                            "the instruments are hidden",
                            () -> driver.window().getWidth() == width && !chart.isShowing());
            driver.choose("instruments");
            driver.robot().waitFor("the chart shows", chart::isShowing);
            driver.robot().waitForPaint();
            int chartHeight = callOnEdt(chart::getHeight);
            assertTrue(chartHeight >= 80, "chart " + chartHeight);
            Rectangle lanes = callOnEdt(() -> ComponentFinder.findAll(driver.window(), LaneView.class)
                    .findFirst()
                    .orElseThrow()
                    .getVisibleRect());
            TimeBar slider = ComponentFinder.findAll(driver.window(), TimeBar.class)
                    .findFirst()
                    .orElseThrow();
            int canvas = callOnEdt(() -> driver.canvas().getHeight());
            assertTrue(canvas >= 40 && canvas >= lanes.height, "canvas " + canvas + ", lanes " + lanes);
            assertEquals(slider.getHeight(), callOnEdt(() -> slider.getVisibleRect().height), "slider");
        }
    }

    private static Stream<Arguments> largeWindows() {
        // A window of usual size, the default one on a screen of 1920x1080, and a maximised one on 3200x2000 at scale
        // 2.
        return Stream.of(
                        Arguments.of(1366, 830, TextSize.LARGE),
                        Arguments.of(1728, 972, TextSize.LARGEST),
                        Arguments.of(1600, 1000, TextSize.LARGEST))
                .flatMap(window -> Stream.of(Language.values())
                        .map(language -> Arguments.of(window.get()[0], window.get()[1], window.get()[2], language)));
    }

    @ParameterizedTest
    @MethodSource("largeWindows")
    void aLargeWindowShowsTheInstrumentsWithLargeText(int width, int height, TextSize size, Language language) {
        WindowDriver.installChoices(language, size);
        try (WindowDriver driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/yard.xml"))) {
            runOnEdt(() -> driver.window().setSize(width, height));
            driver.robot()
                    .waitFor("the window has its size", () -> driver.window().getHeight() == height);
            driver.robot().waitForPaint();
            Component chart = ComponentFinder.find(driver.window(), JComponent.class, Messages.get("strip.view"));
            assertTrue(callOnEdt(chart::isShowing), "the instruments are hidden");
            int chartHeight = callOnEdt(chart::getHeight);
            assertTrue(chartHeight >= MIN_CHART, "chart " + chartHeight);
            Dimension canvas = callOnEdt(() -> driver.canvas().getSize());
            int root = callOnEdt(() -> driver.window().getRootPane().getHeight());
            assertTrue(2 * canvas.height >= root, canvas + " in " + root);
        }
    }

    private static boolean scrollsSideways(WindowDriver driver) {
        return callOnEdt(() -> ComponentFinder.findAll(driver.window(), ControlPanel.class)
                .flatMap(panel -> ComponentFinder.findAll(panel, JScrollPane.class))
                .anyMatch(scroll -> scroll.getHorizontalScrollBar().isShowing()));
    }
}
