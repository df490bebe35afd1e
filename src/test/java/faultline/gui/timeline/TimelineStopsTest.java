package faultline.gui.timeline;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Vector2;
import faultline.gui.theme.Theme;
import faultline.robot.MotorFaults;
import faultline.world.Collision;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The stops of the time line in a run in which nothing has happened yet. */
class TimelineStopsTest {

    private final OpenLanes open = OpenLanes.open();

    @AfterEach
    void close() {
        open.close();
    }

    private TimelinePanel createPanel() {
        Theme.LIGHT.install();
        TimelinePanel panel = new TimelinePanel(tick -> {}, frame -> {}, open.editor());
        panel.addNotify();
        panel.setSize(800, 400);
        panel.validate();
        return panel;
    }

    private void setTimeline(TimedCommand... commands) {
        open.run().change(old -> old.withSetup(old.setup().withTimeline(List.of(commands))));
    }

    private static TimedCommand slowAt(double seconds) {
        return new TimedCommand(seconds, new Command.SetPlatform(0.2, 0.25, 0.2));
    }

    private static List<Long> ticksOf(TimelinePanel panel) {
        List<Long> ticks = new ArrayList<>();
        OptionalLong next = panel.stops().after(0, 1000);
        while (next.isPresent()) {
            ticks.add(next.getAsLong());
            next = panel.stops().after(next.getAsLong(), 1000);
        }
        return ticks;
    }

    /** The frame of the run before is still the newest one. */
    @Test
    void aChangeOfTheTimelineMovesTheStopsAtOnce() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            SessionFrame frame = open.workspace().session().orElseThrow().frame();
            setTimeline(slowAt(1));
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(100L), ticksOf(panel));
            setTimeline(slowAt(2), slowAt(3));
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(200L, 300L), ticksOf(panel));
            panel.removeNotify();
        });
    }

    @Test
    void theContactOfTheGhostIsAStopUnlessTheGhostIsLongerThanTheRun() {
        Collision collision = new Collision(new Vector2(1, 2), 1.5, 150, "desk", Map.of(), List.of(), MotorFaults.NONE);
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            SessionFrame frame = open.workspace().session().orElseThrow().frame();
            setTimeline();
            panel.setGhostContact(new RunEvent.GhostCollided(150, collision));
            panel.setFrame(frame, 100, 100);
            assertEquals(List.of(), ticksOf(panel));
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(150L), ticksOf(panel));
            assertEquals(
                    "first contact of the ghost with desk at 1.000, 2.000",
                    panel.stops().text(150));
            panel.setGhostContact(null);
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(), ticksOf(panel));
            panel.removeNotify();
        });
    }

    @Test
    void theFirstDifferenceFromTheGhostIsAStop() {
        runOnEdt(() -> {
            TimelinePanel panel = createPanel();
            SessionFrame frame = open.workspace().session().orElseThrow().frame();
            setTimeline();
            panel.bar().setDivergence(new RunEvent.Diverged(120, 1.2));
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(120L), ticksOf(panel));
            assertEquals(
                    EventText.sentence(new RunEvent.Diverged(120, 1.2)),
                    panel.stops().text(120));
            panel.bar().setDivergence(null);
            panel.setFrame(frame, 1000, 1000);
            assertEquals(List.of(), ticksOf(panel));
            panel.removeNotify();
        });
    }
}
