package faultline.gui.timeline;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.Recorder;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.SessionFrame;
import faultline.gui.ComponentFinder;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.FlatSliderUI;
import faultline.gui.theme.SliderMark;
import faultline.gui.theme.Theme;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import javax.swing.JSlider;
import org.junit.jupiter.api.Test;

class TimelinePanelTest {

    /** Creates a panel of 800 x 400 pixels that is laid out. */
    private static TimelinePanel createPanel() {
        RunController run = new RunController(new Workspace());
        UndoController undo = new UndoController(new CommandSender(run::send), () -> {});
        return createPanel(new TimelineEditor(new Workspace(), run, undo, note -> {}));
    }

    private static TimelinePanel createPanel(TimelineEditor editor) {
        Theme.LIGHT.install();
        TimelinePanel panel = new TimelinePanel(tick -> {}, frame -> {}, editor);
        panel.addNotify();
        panel.setSize(800, 400);
        panel.validate();
        return panel;
    }

    @Test
    void theLanesOfTheDefaultRobotStandDisabledBeforeThereIsAScenario() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            LaneLayout lanes = panel.lanes().lanes();
            assertEquals(11, lanes.lanes().size(), "eight sensors, two sides of motors, and all else");
            assertEquals("front", lanes.lanes().get(0).label());
            assertTrue(lanes.axis().left() > 60, "room for the names, " + lanes.axis());
            assertFalse(panel.lanes().isEnabled());
            panel.removeNotify();
        });
    }

    /** A window that another program resizes has no newer frame at pause. */
    @Test
    void theLanesStayAlignedWithTheSliderOfAnotherWidthWithoutAFrame() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            panel.lanes().update(panel.lanes().lanes().lanes(), panel.bar().axis(), 0);
            double before = panel.lanes().axis().right();
            panel.setSize(1000, 400);
            panel.validate();
            assertEquals(before + 200, panel.lanes().axis().right());
            panel.removeNotify();
        });
    }

    /**
     * A command of the timeline is moved, so that the run has as many events as before, the first and the last equal.
     */
    @Test
    void theStopsAreThoseOfTheNewestRun() throws ScenarioException {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        SessionFrame before = frameAt(200, withSettingAt(1, office));
        SessionFrame after = frameAt(200, withSettingAt(1.4, office));
        assertEquals(
                before.recording().events().endIndex(),
                after.recording().events().endIndex());
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            panel.setFrame(before, 200, 200);
            assertEquals(List.of(50L, 100L, 180L), ticksOf(panel.stops()));
            panel.setFrame(after, 200, 200);
            assertEquals(List.of(50L, 140L, 180L), ticksOf(panel.stops()));
            panel.removeNotify();
        });
    }

    /** Returns a set-up with three changes of a setting, one of them at a time in seconds. */
    private static SimulationSetup withSettingAt(double seconds, SimulationSetup setup) {
        return setup.withTimeline(List.of(slowAt(0.5), slowAt(seconds), slowAt(1.8)));
    }

    private static SimulationSetup.TimedCommand slowAt(double seconds) {
        return new SimulationSetup.TimedCommand(seconds, new Command.SetPlatform(0.2, 0.25, 0.2));
    }

    private static List<Long> ticksOf(EventStops stops) {
        List<Long> ticks = new ArrayList<>();
        OptionalLong next = stops.after(0, 200);
        while (next.isPresent()) {
            ticks.add(next.getAsLong());
            next = stops.after(next.getAsLong(), 200);
        }
        return ticks;
    }

    private static SessionFrame frameAt(long tick, SimulationSetup setup) {
        Recorder recorder = new Recorder(setup);
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT, recorder)) {
            while (simulation.frame().snapshot().tick() < tick) {
                simulation.tick();
                recorder.observe(simulation);
            }
            return SampleSessionFrames.unmeasured(simulation.frame(), recorder.view());
        }
    }

    /** The colour of a sensor depends on its place, also before anything has happened. */
    @Test
    void aMarkHasTheColourThatItsSensorHasNow() {
        OpenLanes lanes = OpenLanes.open();
        runOnEdt(() -> {
            lanes.run()
                    .change(old -> old.withSetup(old.setup()
                            .withTimeline(List.of(new SimulationSetup.TimedCommand(
                                    1, new Command.InjectFault("left", new Fault.Stuck(0.3)))))));
            SimulationSetup setup = lanes.workspace().scenario().orElseThrow().setup();
            RobotSpec robot = setup.robot();
            RobotSpec other = robot.withSensors(List.of(robot.sensor("left").orElseThrow()));
            TimelinePanel panel = createPanel(lanes.editor());
            panel.setFrame(frameAt(0, setup), 200, 200);
            Color before = faultColour(panel);
            panel.setFrame(frameAt(0, setup.withRobot(other)), 200, 200);
            assertNotEquals(before, faultColour(panel));
            panel.removeNotify();
        });
        lanes.close();
    }

    /** Returns the colour of the first mark. */
    private static Color faultColour(TimelinePanel panel) {
        JSlider slider =
                ComponentFinder.findAll(panel, JSlider.class).findFirst().orElseThrow();
        List<?> marks = (List<?>) slider.getClientProperty(FlatSliderUI.MARKS_PROPERTY);
        return ((SliderMark) marks.get(0)).colour().apply(Theme.LIGHT);
    }

    /** Their texts take time, and the run may continue for hours. */
    @Test
    void aFramePastTheEndOfTheScenarioMakesNoNewMarks() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("office.xml").setup().withDuration(0.05);
        Recorder recorder = new Recorder(setup);
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT, recorder)) {
            runOnEdt(() -> {
                TimelinePanel panel = createPanel();
                EventStops stops = null;
                while (simulation.frame().snapshot().tick() < setup.ticks() + 3) {
                    simulation.tick();
                    recorder.observe(simulation);
                    SessionFrame frame = SampleSessionFrames.unmeasured(simulation.frame(), recorder.view());
                    long last = Math.max(frame.snapshot().tick(), setup.ticks());
                    panel.setFrame(frame, last, setup.ticks());
                    assertEquals(last, panel.bar().end());
                    assertTrue(stops == null || stops == panel.stops(), "new marks at tick " + last);
                    stops = panel.stops();
                }
                panel.removeNotify();
            });
        }
    }
}
