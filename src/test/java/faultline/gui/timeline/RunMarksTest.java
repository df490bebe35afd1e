package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.Recorder;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.SliderMark;
import faultline.gui.theme.Theme;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The marks of a run that drives straight into a wall with a broken sensor. */
class RunMarksTest {

    private static final TimelineItem FAULT =
            new TimelineItem(new Command.InjectFault("left", new Fault.Dead()), 1.5, 2.5);

    private static final Command.ConfigureController CHANGE =
            new Command.ConfigureController(new ControllerSpec.Drive(2, 1.9));

    private static SessionFrame crash(SimulationSetup setup) {
        Recorder recorder = new Recorder(setup);
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT, recorder)) {
            recorder.observe(simulation);
            while (simulation.collision().isEmpty()) {
                simulation.tick();
                recorder.observe(simulation);
            }
            return SampleSessionFrames.unmeasured(simulation.frame(), recorder.view());
        }
    }

    @Test
    void faultsTheEndAndTheCollisionAreMarkedInThisOrder() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("office.xml")
                .setup()
                .withController(new ControllerSpec.Drive(2, 2))
                .withDuration(100);
        SessionFrame frame = crash(setup);
        List<SliderMark> marks = RunMarks.of(frame, List.of(FAULT), setup.ticks(), List.of());
        assertEquals(
                List.of(setup.tickAt(1.5), setup.ticks(), frame.snapshot().tick()),
                marks.stream().map(mark -> (long) mark.value()).toList());
        assertEquals(
                List.of(SliderMark.MarkShape.TICK, SliderMark.MarkShape.TICK, SliderMark.MarkShape.DISC),
                marks.stream().map(SliderMark::form).toList());
        assertEquals("left: off, no reading, 1.50 – 2.50 s", marks.get(0).text());
        assertEquals(
                Theme.LIGHT.palette().sensorColours(2).outline(),
                marks.get(0).colour().apply(Theme.LIGHT));
        assertEquals(Theme.LIGHT.palette().collision(), marks.get(2).colour().apply(Theme.LIGHT));
    }

    @Test
    void theContactOfTheGhostIsADiscOfItsColourBelowTheOtherMarks() throws ScenarioException {
        SessionFrame frame =
                crash(Scenario.loadShipped("office.xml").setup().withController(new ControllerSpec.Drive(2, 2)));
        RunEvent.GhostCollided contact =
                new RunEvent.GhostCollided(50, frame.snapshot().collision().orElseThrow());
        List<SliderMark> marks = RunMarks.of(frame, List.of(), 0, List.of(new RunEvent.Diverged(20, 0.2), contact));
        assertEquals(2, marks.size());
        assertEquals(50, marks.get(0).value());
        assertEquals(SliderMark.MarkShape.DISC, marks.get(0).form());
        assertEquals(Theme.LIGHT.palette().reference(), marks.get(0).colour().apply(Theme.LIGHT));
        assertEquals(EventText.sentence(contact), marks.get(0).text());
    }

    @Test
    void theRunCanBeMovedToTheStartAndTheEndOfAFaultAndToTheCollision() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("office.xml")
                .setup()
                .withController(new ControllerSpec.Drive(2, 2))
                .withDuration(100);
        SessionFrame frame = crash(setup);
        long collision = frame.snapshot().tick();
        EventStops stops = new EventStops(RunMarks.stops(frame, List.of(FAULT)));
        assertEquals(OptionalLong.of(setup.tickAt(1.5)), stops.after(0, setup.ticks()));
        assertEquals("left: off, no reading begins", stops.text(setup.tickAt(1.5)));
        assertEquals(OptionalLong.of(setup.tickAt(2.5)), stops.after(setup.tickAt(1.5), setup.ticks()));
        assertEquals("left: off, no reading ends", stops.text(setup.tickAt(2.5)));
        assertEquals(OptionalLong.of(collision), stops.after(setup.tickAt(2.5), setup.ticks()));
        assertEquals(OptionalLong.empty(), stops.after(collision, setup.ticks()));
    }

    /** The second time is between two ticks, so the command is executed at the later one. */
    @ParameterizedTest
    @ValueSource(doubles = {0.7, 0.704})
    void aChangeOfTheControllerIsMarkedOnceWhetherItIsAnItemOrWasMadeDuringTheRun(double time)
            throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("office.xml")
                .setup()
                .withController(new ControllerSpec.Drive(2, 2))
                .withTimeline(List.of(new SimulationSetup.TimedCommand(time, CHANGE)));
        SessionFrame frame = crash(setup);
        TimelineItem item = TimelineItem.from(CHANGE, time);
        for (List<TimelineItem> items : List.of(List.of(item), List.<TimelineItem>of())) {
            List<SliderMark> marks = RunMarks.of(frame, items, 0, List.of());
            assertEquals(
                    List.of(setup.tickAt(time), frame.snapshot().tick()),
                    marks.stream().map(mark -> (long) mark.value()).toList());
            assertEquals(
                    "Controller: constant voltages 2 V and 1.9 V",
                    marks.get(0).text().replaceAll(", 0.7\\d+ s$", ""));
            assertEquals(Theme.LIGHT.palette().muted(), marks.get(0).colour().apply(Theme.LIGHT));
        }
    }
}
