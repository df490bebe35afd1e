package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.control.FollowerState;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Vector2;
import faultline.gui.theme.Glyph;
import faultline.robot.MotorFaults;
import faultline.sensor.Fault;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Refusal;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Every kind of event has a different name, shape and sentence. */
class EventKindTest {

    private static final Command OFF = new Command.SwitchSensor("left", false);

    private static final Collision CONTACT =
            new Collision(new Vector2(1, 2), 0.08, 8, "desk", Map.of(), List.of(), MotorFaults.NONE);

    private static final List<RunEvent> EVENTS = List.of(
            new RunEvent.StateChanged(1, 0.01, FollowerState.SEARCH, FollowerState.TURN, ""),
            new RunEvent.AlignmentTimed(2, 0.02, new Telemetry.EdgeTimes(0.01, 0.02, 0.005, 0), TimingRule.RANGE),
            new RunEvent.HealthChanged(3, 0.03, SensorTrust.DISTRUSTED, SensorHealth.trusted("left")),
            new RunEvent.HealthChanged(
                    3,
                    0.03,
                    SensorTrust.TRUSTED,
                    new SensorHealth("left", SensorTrust.DISTRUSTED, SensorFinding.NONE, 8, 3)),
            new RunEvent.RungChanged(4, 0.04, "ALL", "TWO"),
            new RunEvent.CommandExecuted(5, 0.05, new Command.InjectFault("left", new Fault.Dead())),
            new RunEvent.CommandExecuted(6, 0.06, new Command.ClearFaults("left")),
            new RunEvent.CommandExecuted(7, 0.07, OFF),
            new RunEvent.CommandRefused(7, 0.07, OFF, new Refusal(Refusal.Reason.UNKNOWN_SENSOR, "left")),
            new RunEvent.Collided(8, CONTACT),
            new RunEvent.Diverged(9, 0.09),
            new RunEvent.GhostCollided(9, CONTACT),
            new RunEvent.Printed(9, 0.09, "connected"));

    @Test
    void everyClassOfEventsIsAmongTheKinds() {
        Set<Class<?>> classes = EVENTS.stream().map(Object::getClass).collect(Collectors.toSet());
        assertEquals(Set.of(RunEvent.class.getPermittedSubclasses()), classes);
        List<EventKind> kinds = EVENTS.stream().map(EventKind::of).toList();
        assertEquals(EnumSet.allOf(EventKind.class), EnumSet.copyOf(kinds));
        assertEquals(EVENTS.size(), new HashSet<>(kinds).size(), kinds.toString());
    }

    @Test
    void onlyTheTwoFindingsAboutASensorAndTheContactsHaveTheSameShape() {
        List<Glyph> marks = EVENTS.stream()
                .map(event -> EventKind.of(event).mark())
                .distinct()
                .toList();
        assertEquals(EVENTS.size() - 2, marks.size(), marks.toString());
        assertEquals(EventKind.TRUST.mark(), EventKind.DISTRUST.mark());
        assertEquals(EventKind.COLLISION.mark(), EventKind.GHOST_COLLISION.mark());
    }

    @Test
    void everyEventHasASentenceOfItsOwn() {
        List<String> sentences = EVENTS.stream().map(EventText::sentence).toList();
        assertEquals(EVENTS.size(), new HashSet<>(sentences).size(), sentences.toString());
        assertFalse(sentences.contains(""), sentences.toString());
    }

    @Test
    void faultsFindingsRefusalsAndCollisionsWarn() {
        assertEquals(
                List.of(
                        "State",
                        "Timing",
                        "Health",
                        "Health!",
                        "Strategy",
                        "Fault!",
                        "Fault",
                        "Command",
                        "Refused!",
                        "Collision!",
                        "Ghost",
                        "Ghost",
                        "Output"),
                EVENTS.stream()
                        .map(EventKind::of)
                        .map(kind -> kind.text() + (kind.isWarning() ? "!" : ""))
                        .toList());
    }
}
