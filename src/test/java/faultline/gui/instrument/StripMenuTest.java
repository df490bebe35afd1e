package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.ComponentFinder;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The context menu of a strip chart without a display. */
class StripMenuTest {

    private StripChart chart;

    @BeforeEach
    void show() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            chart = new StripChart();
            chart.setFrame(SampleRuns.frame(2000));
            SampleRuns.render(chart, 560, 220);
        });
    }

    /** Returns the items of the menu as it opens now. */
    private List<JMenuItem> items() {
        return items(callOnEdt(chart::createMenu).getComponents());
    }

    private static List<JMenuItem> items(Component... components) {
        return Stream.of(components)
                .filter(JMenuItem.class::isInstance)
                .map(JMenuItem.class::cast)
                .toList();
    }

    private JMenuItem item(String text) {
        return items().stream()
                .filter(item -> item.getText().equals(text))
                .findFirst()
                .orElseThrow();
    }

    private List<JMenuItem> submenu(String text) {
        return items(((JMenu) item(text)).getMenuComponents());
    }

    private static void click(JMenuItem item) {
        runOnEdt(() -> item.doClick(0));
    }

    private boolean isPressed(String button) {
        return callOnEdt(
                () -> ComponentFinder.find(chart, JToggleButton.class, button).isSelected());
    }

    @Test
    void itsItemsFollowTheActionsOfTheWindow() {
        chart.setMenuExtension(menu -> menu.add(new JMenuItem("Export")));
        assertEquals(
                List.of(
                        "Signals",
                        "Add signals",
                        "Hold the chart",
                        "Fit the vertical axis",
                        "Reset the zoom",
                        "Export"),
                items().stream().map(JMenuItem::getText).toList());
    }

    @Test
    void itHoldsAndFitsAsTheButtonsDo() {
        for (List<String> names : List.of(
                List.of("Hold the chart", "Hold the strip chart"),
                List.of("Fit the vertical axis", "Fit the vertical axis"))) {
            assertFalse(item(names.get(0)).isSelected());
            click(item(names.get(0)));
            assertTrue(isPressed(names.get(1)));
            assertTrue(item(names.get(0)).isSelected());
        }
        assertEquals(ValueRange.FITTED, chart.view().range());
        runOnEdt(() -> chart.setFrame(SampleRuns.frame(2100)));
        assertEquals(20, chart.view().span().end(), 1e-9);
    }

    @Test
    void itChoosesAndAddsSignals() {
        click(submenu("Signals").get(5));
        JComboBox<?> choice = ComponentFinder.find(chart, JComboBox.class, "Signals");
        assertEquals(5, callOnEdt(choice::getSelectedIndex));
        assertTrue(submenu("Signals").get(5).isSelected());
        int before = lines();
        click(submenu("Add signals").get(0));
        assertEquals(before + 1, lines());
        assertTrue(submenu("Add signals").get(0).isSelected());
    }

    private int lines() {
        return callOnEdt(
                () -> chart.view().scale().orElseThrow().signal().lines().size());
    }

    @Test
    void nothingCanBeAddedIfNoSignalHasTheSameUnit() {
        assertTrue(item("Add signals").isEnabled());
        click(submenu("Signals").get(2));
        assertEquals("3  Wheel voltages", submenu("Signals").get(2).getText());
        assertFalse(item("Add signals").isEnabled());
    }

    @Test
    void resettingTheZoomKeepsAHeldChartAtItsTime() {
        runOnEdt(() -> {
            chart.view().getActionMap().get("LEFT").actionPerformed(null);
            chart.view().setSpan(new TimeSpan(13, 4));
            chart.view().setRange(ValueRange.fixed(0.2, 0.3));
        });
        click(item("Reset the zoom"));
        assertEquals(new TimeSpan(7, 10), chart.view().span());
        assertEquals(ValueRange.FROM_ZERO, chart.view().range());
        assertTrue(isPressed("Hold the strip chart"));
    }

    @Test
    void aDragWithTheRightButtonDoesNotScroll() {
        TimeSpan before = chart.view().span();
        runOnEdt(() -> Stream.of(300, 200).forEach(x -> chart.view()
                .dispatchEvent(new MouseEvent(
                        chart.view(),
                        x == 300 ? MouseEvent.MOUSE_PRESSED : MouseEvent.MOUSE_DRAGGED,
                        0,
                        InputEvent.BUTTON3_DOWN_MASK,
                        x,
                        80,
                        1,
                        false,
                        MouseEvent.BUTTON3))));
        assertEquals(before, chart.view().span());
        assertFalse(isPressed("Hold the strip chart"));
    }

    @Test
    void theRightButtonAndBothKeysRequestIt() {
        int[] requests = {0};
        StripView view = callOnEdt(() -> new StripView(() -> false));
        runOnEdt(() -> {
            new StripChartMouse(view, hold -> {}, at -> requests[0]++).install();
            view.dispatchEvent(new MouseEvent(
                    view,
                    MouseEvent.MOUSE_PRESSED,
                    0,
                    InputEvent.BUTTON3_DOWN_MASK,
                    30,
                    40,
                    1,
                    true,
                    MouseEvent.BUTTON3));
            for (String key : List.of("shift F10", "CONTEXT_MENU")) {
                view.getActionForKeyStroke(KeyStroke.getKeyStroke(key))
                        .actionPerformed(new ActionEvent(view, ActionEvent.ACTION_PERFORMED, ""));
            }
        });
        assertEquals(3, requests[0]);
    }

    @Test
    void anEmptyChartHasAMenuToo() {
        JPopupMenu menu = callOnEdt(() -> new StripChart().createMenu());
        assertEquals(6, menu.getComponentCount());
    }
}
