package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.properties.ObstaclePanel;
import faultline.gui.theme.Theme;
import faultline.world.Obstacle;
import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** The selected obstacle gets another id in the Obstacles tab, and remains selected. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ObstacleIdRobotTest {

    private WindowDriver driver;
    private JTextField field;
    private JList<?> list;

    @BeforeEach
    void open() {
        driver = WindowDriver.open(Theme.LIGHT, Path.of("scenarios/office.xml"));
        ObstaclePanel panel = callOnEdt(() -> ComponentFinder.findAll(driver.window(), ObstaclePanel.class)
                .findFirst()
                .orElseThrow());
        field = ComponentFinder.find(panel, JTextField.class, "Id");
        list = ComponentFinder.find(panel, JList.class, "Obstacles");
        runOnEdt(() -> {
            ComponentFinder.find(driver.window(), JTabbedPane.class, "Control panel")
                    .setSelectedComponent(tabOf(panel));
            driver.canvas().tools().select(List.of("copier"));
        });
        driver.robot().waitFor("its id", () -> field.getText().equals("copier") && field.isShowing());
    }

    private static Component tabOf(Component component) {
        return component.getParent() instanceof JTabbedPane ? component : tabOf(component.getParent());
    }

    @AfterEach
    void close() {
        driver.close();
    }

    private void type(int... keys) {
        driver.robot().click(field, 5, 5, InputEvent.BUTTON1_DOWN_MASK);
        driver.robot().waitFor("the focus", field::isFocusOwner);
        driver.robot().pressKeys(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        for (int key : keys) {
            driver.robot().pressKeys(key);
        }
    }

    private static boolean has(Frame frame, String id) {
        return frame.snapshot().obstacles().stream().map(Obstacle::id).anyMatch(id::equals);
    }

    private List<String> selected() {
        return callOnEdt(() ->
                driver.canvas().tools().selected().stream().map(Obstacle::id).toList());
    }

    @Test
    void theIdThatIsTypedIsThatOfTheObstacleEverywhere() {
        type(KeyEvent.VK_F, KeyEvent.VK_A, KeyEvent.VK_X, KeyEvent.VK_ENTER);
        driver.waitForFrame("the new id", frame -> has(frame, "fax"));
        driver.robot().waitFor("it is selected in the list", () -> "fax".equals(list.getSelectedValue()));
        assertEquals(List.of("fax"), selected());
        assertEquals("fax", callOnEdt(field::getText));
        driver.choose("delete");
        driver.waitForFrame("it is deleted", frame -> !has(frame, "fax"));
        driver.choose("undo");
        driver.waitForFrame("it is back", frame -> has(frame, "fax"));
        driver.choose("undo");
        driver.waitForFrame("its old id", frame -> has(frame, "copier"));
        driver.waitForTitle("office.xml");
    }

    @Test
    void aDragThatLeavesTheFieldAppliesTheIdAndMovesTheObstacle() {
        Pose before = driver.frame().snapshot().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals("copier"))
                .findFirst()
                .orElseThrow()
                .pose();
        type(KeyEvent.VK_F, KeyEvent.VK_A, KeyEvent.VK_X);
        Vector2 at = callOnEdt(() -> driver.canvas().camera().toScreen(before.position()));
        driver.robot()
                .drag(
                        driver.canvas(),
                        (int) at.x(),
                        (int) at.y(),
                        (int) at.x() - 40,
                        (int) at.y() + 40,
                        InputEvent.BUTTON1_DOWN_MASK);
        driver.waitForFrame("it has its id and another place", frame -> frame.snapshot().obstacles().stream()
                .anyMatch(obstacle ->
                        obstacle.id().equals("fax") && !obstacle.pose().equals(before)));
    }

    @Test
    void anIdWithASpaceIsSelectedByItsLetters() {
        runOnEdt(() -> {
            field.setText("big fax");
            field.postActionEvent();
            driver.canvas().tools().select(List.of("desk"));
        });
        driver.waitForFrame("the new id", frame -> has(frame, "big fax"));
        driver.robot().waitFor("another one is selected", () -> field.getText().equals("desk"));
        runOnEdt(() -> field.setText("big box"));
        runOnEdt(() -> field.postActionEvent());
        driver.waitForFrame("both ids", frame -> has(frame, "big box"));
        driver.robot().waitFor("they are listed", () -> "big box".equals(list.getSelectedValue()));
        runOnEdt(() -> list.requestFocusInWindow());
        driver.robot().waitFor("the focus", list::isFocusOwner);
        for (int key : new int[] {KeyEvent.VK_B, KeyEvent.VK_I, KeyEvent.VK_G, KeyEvent.VK_SPACE, KeyEvent.VK_F}) {
            driver.robot().pressKeys(key);
        }
        driver.robot().waitFor("the fax", () -> "big fax".equals(list.getSelectedValue()));
        assertEquals(0, driver.frame().snapshot().tick());
    }

    @Test
    void anIdThatIsTakenIsRefusedAndStaysInTheField() {
        type(KeyEvent.VK_D, KeyEvent.VK_E, KeyEvent.VK_S, KeyEvent.VK_K, KeyEvent.VK_ENTER);
        driver.robot().waitFor("the reason", () -> Optional.of("The scenario already has an obstacle with the id desk")
                .equals(Optional.ofNullable(field.getAccessibleContext().getAccessibleDescription())));
        assertEquals("desk", callOnEdt(field::getText));
        driver.robot().pressKeys(KeyEvent.VK_ESCAPE);
        driver.robot().waitFor("the id", () -> field.getText().equals("copier"));
        assertEquals(List.of("copier"), selected());
    }

    /** The views have the old id until the run has the new one. */
    @Test
    void anObstacleThatIsDeletedAtOnceIsTheRenamedOne() {
        runOnEdt(() -> {
            field.setText("fax");
            field.postActionEvent();
            driver.chooseOnEdt("delete");
        });
        driver.waitForFrame("it is deleted", frame -> !has(frame, "fax") && !has(frame, "copier"));
        driver.choose("undo");
        driver.waitForFrame("it is back", frame -> has(frame, "fax"));
    }
}
