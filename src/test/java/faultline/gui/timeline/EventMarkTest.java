package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.FollowerState;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Vector2;
import faultline.gui.theme.Glyph;
import faultline.sensor.Fault;
import faultline.world.Collision;
import faultline.world.Command;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Every kind of event has a shape of its own. */
class EventMarkTest {

    @Test
    void noTwoKindsOfEventsHaveTheSameShape() {
        List<RunEvent> events = List.of(
                new RunEvent.StateChanged(1, 0.01, FollowerState.SEARCH, FollowerState.TURN, ""),
                new RunEvent.AlignmentTimed(2, 0.02, 0.01, 0.02, 0.005),
                new RunEvent.HealthChanged(3, 0.03, SensorTrust.TRUSTED, SensorHealth.trusted("left")),
                new RunEvent.RungChanged(4, 0.04, "ALL", "TWO"),
                new RunEvent.CommandExecuted(5, 0.05, new Command.InjectFault("left", new Fault.Dead())),
                new RunEvent.CommandExecuted(6, 0.06, new Command.ClearFaults("left")),
                new RunEvent.CommandExecuted(7, 0.07, new Command.SwitchSensor("left", false)),
                new RunEvent.Collided(8, new Collision(new Vector2(1, 2), 0.08, 8, "desk", Map.of(), List.of())),
                new RunEvent.Diverged(9, 0.09));
        List<Glyph> marks = events.stream().map(EventMark::of).distinct().toList();
        assertEquals(events.size(), marks.size(), marks.toString());
    }
}
