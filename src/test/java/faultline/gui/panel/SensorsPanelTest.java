package faultline.gui.panel;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.NumberSpinner;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.awt.Rectangle;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class SensorsPanelTest {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** A field that is removed with its row loses the focus and commits its text, as here. */
    @Test
    void whatIsTypedForASensorThatTheNextRobotLacksChangesNothing() {
        Snapshot world = SampleFrames.fullFrame().snapshot();
        List<Command> commands = new ArrayList<>();
        runOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((sent, onExecuted) -> commands.addAll(sent));
            SensorsPanel panel = new SensorsPanel(sender);
            sender.pendingEdits().setRobot(world.robot());
            panel.setSensors(world.sensors());
            NumberSpinner range = NumberSpinner.findIn(panel).findFirst().orElseThrow();
            range.textField().setText("0.77");
            sender.pendingEdits().setRobot(world.robot().withSensors(List.of()));
            panel.setSensors(List.of());
            range.commitPendingEdit();
            assertEquals(List.of(), commands);
        });
    }

    /** Swing paints and shows each component for itself, unless one around it must be painted, too. */
    @Test
    void theReadingsOfAFrameArePaintedTogether() {
        List<Rectangle> painted = new ArrayList<>();
        runOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((sent, onExecuted) -> {});
            SensorsPanel panel = new SensorsPanel(sender);
            sender.pendingEdits().setRobot(RobotSpec.DEFAULT);
            panel.setSensors(sensorsAt(2.5));
            panel.setSize(panel.getPreferredSize());
            panel.doLayout();
            RepaintManager before = RepaintManager.currentManager(panel);
            RepaintManager.setCurrentManager(new RepaintManager() {
                @Override
                public void addDirtyRegion(JComponent part, int x, int y, int width, int height) {
                    if (part == panel && width > 0) {
                        painted.add(new Rectangle(x, y, width, height));
                    }
                }
            });
            try {
                panel.setSensors(sensorsAt(2.5));
                assertEquals(List.of(), painted, "nothing has changed");
                panel.setSensors(sensorsAt(4.6));
            } finally {
                RepaintManager.setCurrentManager(before);
            }
            assertEquals(1, painted.size());
            assertTrue(
                    ComponentFinder.findAll(panel, ReadingBar.class)
                                    .map(ReadingBar::getBounds)
                                    .filter(painted.get(0)::contains)
                                    .count()
                            >= 4,
                    "both readings of two sensors or more");
        });
    }

    /** Returns the sensors of a robot in a room of 5 m, which looks at the right wall. */
    private static List<SensorSnapshot> sensorsAt(double x) {
        World world =
                new World(new WorldSpec(5, 5, true, 0, List.of()), RobotSpec.DEFAULT, new Pose(x, 2.5, 0), 0.01, 0);
        world.sense();
        return world.snapshot().sensors();
    }

    /** What the robot will be after the pending edits is the same for all rows, and has a list of all sensors. */
    @Test
    void theMemoryOfAFrameIsInProportionToTheNumberOfSensors() {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(IntStream.range(0, 500)
                .mapToObj(i -> new SensorSpec("s" + i, Vector2.ZERO, 0, 1, 0.5, true, 0))
                .toList());
        World world = new World(new WorldSpec(5, 5, true, 0, List.of()), robot, new Pose(2, 2, 0), 0.01, 0);
        world.sense();
        List<SensorSnapshot> sensors = world.snapshot().sensors();
        runOnEdt(() -> {
            Theme.LIGHT.install();
            CommandSender sender = new CommandSender((sent, onExecuted) -> {});
            SensorsPanel panel = new SensorsPanel(sender);
            sender.pendingEdits().setRobot(robot);
            sender.send(new Command.ConfigureSensor(robot.sensors().get(300).withRange(1.2)));
            panel.setSensors(sensors);
            long before = THREADS.getCurrentThreadAllocatedBytes();
            panel.setSensors(sensors);
            long bytes = THREADS.getCurrentThreadAllocatedBytes() - before;
            assertTrue(bytes < 5_000_000, bytes + " bytes");
            assertEquals(
                    1.2,
                    NumberSpinner.findIn(panel)
                            .skip(600)
                            .findFirst()
                            .orElseThrow()
                            .getValue());
        });
    }
}
