package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;
import faultline.gui.text.HealthText;
import faultline.gui.text.Messages;
import faultline.gui.text.RefusalText;
import faultline.gui.text.StateText;
import java.util.Locale;

/** Describes the events of a run. */
public final class EventText {

    private EventText() {}

    /** Returns the kind of an event. */
    public static String kind(RunEvent event) {
        if (event instanceof RunEvent.CommandExecuted done) {
            return Messages.get(CommandRole.isFaultChange(done.command()) ? "event.fault" : "event.command");
        }
        if (event instanceof RunEvent.Diverged) {
            return Messages.get("event.ghost");
        }
        if (event instanceof RunEvent.AlignmentTimed) {
            return Messages.get("event.timing");
        }
        if (event instanceof RunEvent.HealthChanged) {
            return Messages.get("event.health");
        }
        if (event instanceof RunEvent.RungChanged) {
            return Messages.get("event.rung");
        }
        return Messages.get(
                event instanceof RunEvent.StateChanged
                        ? "event.transition"
                        : event instanceof RunEvent.CommandRefused ? "event.refused" : "event.collision");
    }

    /** Returns whether an event is a sensor fault, a sensor that is not trusted any more, or a collision. */
    public static boolean isFailure(RunEvent event) {
        return event instanceof RunEvent.Collided
                || event instanceof RunEvent.HealthChanged change
                        && !change.health().isTrusted()
                || event instanceof RunEvent.CommandExecuted done
                        && CommandRole.of(done.command()).isFaultStart();
    }

    public static String time(RunEvent event) {
        return format("%.3f", event.time());
    }

    /** Describes an event. */
    public static String sentence(RunEvent event) {
        if (event instanceof RunEvent.StateChanged move) {
            return StateText.transition(move.from(), move.to(), move.condition());
        }
        if (event instanceof RunEvent.CommandExecuted done) {
            return CommandText.format(done.command());
        }
        if (event instanceof RunEvent.CommandRefused refused) {
            return Messages.get(
                    "event.why", CommandText.format(refused.command()), RefusalText.format(refused.refusal()));
        }
        if (event instanceof RunEvent.AlignmentTimed timing) {
            return Messages.get(
                    "event.timed",
                    format("%.3f", timing.f3()),
                    format("%.3f", timing.f4()),
                    format("%.3f", timing.f4() - timing.f3()),
                    format("%.3f", timing.tP()));
        }
        if (event instanceof RunEvent.HealthChanged change) {
            return HealthText.change(change.from(), change.health());
        }
        if (event instanceof RunEvent.RungChanged change) {
            return Messages.get("event.rung.changed", HealthText.rung(change.from()), HealthText.rung(change.to()));
        }
        return event instanceof RunEvent.Collided collided ? collision(collided) : Messages.get("event.diverged");
    }

    private static String collision(RunEvent.Collided event) {
        return Messages.get(
                "event.collided",
                event.collision().obstacle(),
                format("%.3f", event.collision().point().x()),
                format("%.3f", event.collision().point().y()));
    }

    private static String format(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
