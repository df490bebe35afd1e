package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;
import faultline.gui.text.ContactText;
import faultline.gui.text.HealthText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.text.RefusalText;
import faultline.gui.text.StateText;
import faultline.gui.text.TurnTimes;
import faultline.world.Collision;

/** Describes the events of a run in the user's language. */
public final class EventText {

    private EventText() {}

    /** Returns the time of an event, seconds. */
    public static String time(RunEvent event) {
        return NumberText.format("%.3f", event.time());
    }

    /** Describes an event. */
    public static String sentence(RunEvent event) {
        return event.match(new RunEvent.EventCases<>(
                changed -> StateText.transition(changed.from(), changed.to(), changed.condition()),
                timed -> {
                    TurnTimes times = TurnTimes.of(timed.f3(), timed.f4());
                    return Messages.get("event.timed", times.f3(), times.f4(), times.tD(), times.tP());
                },
                health -> HealthText.change(health.from(), health.health()),
                rung -> Messages.get("event.rung.changed", HealthText.rung(rung.from()), HealthText.rung(rung.to())),
                executed -> CommandText.format(executed.command()),
                refused -> Messages.get(
                        "event.refusal", CommandText.format(refused.command()), RefusalText.format(refused.refusal())),
                collided -> contact("event.collided", collided.collision()),
                diverged -> Messages.get("event.diverged"),
                ghost -> contact("event.ghostCollided", ghost.collision()),
                RunEvent.Printed::line));
    }

    private static String contact(String key, Collision collision) {
        return ContactText.get(
                key,
                collision.obstacle(),
                NumberText.format("%.3f", collision.point().x()),
                NumberText.format("%.3f", collision.point().y()));
    }
}
