package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.timeline.EventKind;
import faultline.gui.timeline.EventText;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Component;
import java.awt.Font;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.swing.JCheckBox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The event log without a display: its texts, and going to an event. */
class EventLogViewTest {

    private final List<Long> jumps = new ArrayList<>();
    private final EventLogView view = callOnEdt(() -> new EventLogView(jumps::add));

    private List<String> rows() {
        return callOnEdt(() -> IntStream.range(0, view.table().getRowCount())
                .mapToObj(row -> view.table().getValueAt(row, 0) + " "
                        + view.table().getValueAt(row, 1) + " " + view.table().getValueAt(row, 2))
                .toList());
    }

    @Test
    void whatHappenedStandsInItsOrder() {
        runOnEdt(() -> view.setFrame(SampleRuns.frame(310)));
        List<String> rows = rows();
        assertEquals("0.000 Command rear switched off", rows.get(0));
        assertTrue(rows.contains("2.000 Fault rear-right: stuck 0.40 m"));
        assertTrue(rows.contains("3.000 Refused nose switched on: the robot has no sensor nose"));
    }

    @Test
    void aLaterFrameAddsItsEventsAndAnotherRunReplacesThem() {
        runOnEdt(() -> view.setFrame(SampleRuns.frame(310)));
        int before = rows().size();
        runOnEdt(() -> view.setFrame(SampleRuns.frame(2000)));
        assertTrue(rows().size() > before);
        runOnEdt(() -> view.setFrame(SampleRuns.frame(100)));
        assertEquals(
                List.of(
                        "0.000 Command rear switched off",
                        "0.010 Health rear is not trusted: it gives no answer",
                        "0.010 Strategy All sensors → Side and front"),
                rows());
    }

    @Test
    void scrolledToItsEndTheFirstRowThatShowsIsWhole() {
        runOnEdt(() -> view.setSize(700, 131));
        for (int pass = 0; pass < 2; pass++) {
            runOnEdt(() -> ComponentFinder.layOut(view));
        }
        runOnEdt(() -> view.setFrame(SampleRuns.frame(2000)));
        runOnEdt(() -> ComponentFinder.layOut(view));
        runOnEdt(() -> view.setFrame(SampleRuns.frame(3000)));
        runOnEdt(() -> ComponentFinder.layOut(view));
        int row = callOnEdt(view.table()::getRowHeight);
        int top = callOnEdt(() -> view.table().getVisibleRect().y);
        assertTrue(top > 0, "it is scrolled");
        assertEquals(0, top % row);
    }

    /** Swing paints components that overlap as if they did not. */
    @Test
    void theFilterIsBesideTheTable() {
        runOnEdt(() -> {
            view.setSize(700, 131);
            ComponentFinder.layOut(view);
        });
        assertFalse(
                callOnEdt(() -> view.getComponent(0)
                        .getBounds()
                        .intersects(view.getComponent(1).getBounds())),
                "they overlap");
    }

    @ParameterizedTest
    @ValueSource(ints = {60, 131, 400})
    void theBoxesOfTheFilterAreNotCutOff(int height) {
        runOnEdt(() -> view.setSize(700, height));
        for (int pass = 0; pass < 2; pass++) {
            runOnEdt(() -> ComponentFinder.layOut(view));
        }
        JCheckBox box = ComponentFinder.find(view, JCheckBox.class, "Commands");
        Component boxes = box.getParent().getParent();
        assertEquals(boxes.getPreferredSize().width, callOnEdt(() -> boxes.getParent()
                .getWidth()));
    }

    @Test
    void theKindsAreNotCutOffInAnyTextSizeAndLanguage() {
        runOnEdt(() -> {
            for (Language language : Language.values()) {
                Messages.setLanguage(language);
                for (TextSize size : TextSize.values()) {
                    size.install();
                    view.table().setFont(TextSize.scaledFont(Font.PLAIN, 15));
                    RefreshSteps.run(view.table());
                    view.setFrame(SampleRuns.frame(2000));
                    int least = view.table().getColumnModel().getColumn(1).getMinWidth();
                    for (int row = 0; row < view.table().getRowCount(); row++) {
                        Component cell =
                                view.table().prepareRenderer(view.table().getCellRenderer(row, 1), row, 1);
                        assertTrue(
                                cell.getPreferredSize().width < least,
                                size + ": " + view.table().getValueAt(row, 1));
                    }
                }
            }
        });
        runOnEdt(() -> {
            Messages.setLanguage(Language.ENGLISH);
            TextSize.NORMAL.install();
        });
    }

    private void show(String group, boolean shown) {
        runOnEdt(() -> {
            JCheckBox box = ComponentFinder.find(view, JCheckBox.class, group);
            if (box.isSelected() != shown) {
                box.doClick(0);
            }
        });
    }

    @Test
    void hiddenGroupsStayHiddenInLaterRunsAndTheOthersOpenTheirMoments() {
        runOnEdt(() -> view.setFrame(SampleRuns.frame(2000)));
        List<String> all = rows();
        show("States", false);
        show("Commands", false);
        List<String> others = all.stream()
                .filter(row -> !row.matches("\\S+ (State|Timing|Command|Refused) .*"))
                .toList();
        assertTrue(!others.isEmpty() && others.size() < all.size());
        assertEquals(others, rows());
        runOnEdt(() -> {
            view.table().setRowSelectionInterval(0, 0);
            view.table().getActionMap().get("ENTER").actionPerformed(null);
        });
        assertEquals(List.of(1L), jumps);
        runOnEdt(() -> view.setFrame(SampleRuns.frame(100)));
        assertEquals(2, rows().size(), "the health and the rung");
        show("States", true);
        show("Commands", true);
        assertEquals(3, rows().size());
    }

    @Test
    void rowsCanBeCopied() {
        runOnEdt(() -> {
            view.setFrame(SampleRuns.frame(100));
            view.table().getActionMap().get("menu A").actionPerformed(null);
        });
        assertEquals(3, callOnEdt(view.table()::getSelectedRowCount));
    }

    @Test
    void enterAndADoubleClickGoToTheMoment() {
        SessionFrame frame = SampleRuns.frame(310);
        runOnEdt(() -> {
            view.setFrame(frame);
            view.table().setRowSelectionInterval(1, 1);
            view.table().getActionMap().get("ENTER").actionPerformed(null);
            view.table().setSize(600, 400);
            view.table()
                    .dispatchEvent(new MouseEvent(
                            view.table(),
                            MouseEvent.MOUSE_CLICKED,
                            0,
                            0,
                            20,
                            view.table().getRowHeight() / 2,
                            2,
                            false));
        });
        assertEquals(List.of(frame.recording().events().get(1).tick(), 0L), jumps);
    }

    @Test
    void everyCommandHasItsOwnWords() {
        Fault bias = new Fault.Bias(0.02);
        List<Command> commands = List.of(
                new Command.SwitchSensor("left", true),
                new Command.SwitchSensor("left", false),
                new Command.ConfigureSensor(RobotSpec.DEFAULT.sensors().get(0)),
                new Command.InjectFault("left", bias),
                new Command.ClearFault("left", bias),
                new Command.ClearFaults("left"),
                new Command.MoveObstacle("desk", new Pose(1, 2, 0)),
                new Command.PlaceObstacle(new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0))),
                new Command.RemoveObstacle("desk"),
                new Command.SetPlatform(0.3, 0.2, 0.4));
        List<String> words = commands.stream()
                .map(command -> EventText.sentence(new RunEvent.CommandExecuted(1, 0.01, command)))
                .toList();
        assertEquals(commands.size(), new HashSet<>(words).size());
        assertEquals("left: bias 0.02 m repaired", words.get(4));
        assertEquals("desk moved to 1.000, 2.000, 0.0°", words.get(6));
        assertEquals("platform 0.300 m × 0.200 m, 0.40 m/s", words.get(9));
    }

    @Test
    void aCollisionSaysWhatAndWhere() {
        Collision collision =
                new Collision(new Vector2(1.5, 2), 3.217, 322, "desk", Map.of(), List.of(), MotorFaults.NONE);
        RunEvent event = new RunEvent.Collided(322, collision);
        assertEquals(
                "3.217 Collision first contact with desk at 1.500, 2.000",
                EventText.time(event) + " " + EventKind.of(event).text() + " " + EventText.sentence(event));
    }
}
