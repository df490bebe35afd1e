package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;
import faultline.gui.text.HealthText;
import faultline.gui.text.Messages;
import faultline.gui.text.RefusalText;
import faultline.gui.text.StateText;
import faultline.gui.text.TurnTimes;
import java.util.Locale;

/** Describes the events of a run in the user's language. */
public final class EventText implements RunEvent.EventVisitor<String> {

    private static final EventText INSTANCE = new EventText();

    private EventText() {}

    /** Returns the time of an event, seconds. */
    public static String time(RunEvent event) {
        return threeDecimals(event.time());
    }

    /** Describes an event. */
    public static String sentence(RunEvent event) {
        return event.accept(INSTANCE);
    }

    @Override
    public String visit(RunEvent.StateChanged event) {
        return StateText.transition(event.from(), event.to(), event.condition());
    }

    @Override
    public String visit(RunEvent.AlignmentTimed event) {
        TurnTimes times = TurnTimes.of(event.f3(), event.f4());
        return Messages.get("event.timed", times.f3(), times.f4(), times.tD(), times.tP());
    }

    @Override
    public String visit(RunEvent.HealthChanged event) {
        return HealthText.change(event.from(), event.health());
    }

    @Override
    public String visit(RunEvent.RungChanged event) {
        return Messages.get("event.rung.changed", HealthText.rung(event.from()), HealthText.rung(event.to()));
    }

    @Override
    public String visit(RunEvent.CommandExecuted event) {
        return CommandText.format(event.command());
    }

    @Override
    public String visit(RunEvent.CommandRefused event) {
        return Messages.get("event.refusal", CommandText.format(event.command()), RefusalText.format(event.refusal()));
    }

    @Override
    public String visit(RunEvent.Collided event) {
        return Messages.get(
                "event.collided",
                event.collision().obstacle(),
                threeDecimals(event.collision().point().x()),
                threeDecimals(event.collision().point().y()));
    }

    @Override
    public String visit(RunEvent.Diverged event) {
        return Messages.get("event.diverged");
    }

    private static String threeDecimals(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }
}
