package faultline.gui.instrument;

import faultline.engine.recording.RunEvent;
import faultline.gui.panel.ReadingText;
import faultline.gui.text.MessageTranslator;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.world.Command;
import java.util.Locale;

/** The events of a run in words. */
final class EventText {

    private EventText() {}

    /** What sort of event it is. */
    static String kind(RunEvent event) {
        if (event instanceof RunEvent.CommandExecuted done) {
            return Messages.get(isFault(done.command()) ? "event.fault" : "event.command");
        }
        if (event instanceof RunEvent.Diverged) {
            return Messages.get("event.ghost");
        }
        return Messages.get(
                event instanceof RunEvent.StateChanged
                        ? "event.transition"
                        : event instanceof RunEvent.CommandRefused ? "event.refused" : "event.collision");
    }

    /** Whether something broke: a sensor, or the run into an obstacle. */
    static boolean isFailure(RunEvent event) {
        return event instanceof RunEvent.Collided
                || event instanceof RunEvent.CommandExecuted done && done.command() instanceof Command.InjectFault;
    }

    private static boolean isFault(Command command) {
        return command instanceof Command.InjectFault
                || command instanceof Command.ClearFault
                || command instanceof Command.ClearFaults;
    }

    static String time(RunEvent event) {
        return format("%.3f", event.time());
    }

    /** What happened. */
    static String sentence(RunEvent event) {
        if (event instanceof RunEvent.StateChanged move) {
            return Messages.get(
                    "diagram.last",
                    StateText.name(move.from()),
                    StateText.name(move.to()),
                    StateText.condition(move.from(), move.to(), move.condition()));
        }
        if (event instanceof RunEvent.CommandExecuted done) {
            return sentence(done.command());
        }
        if (event instanceof RunEvent.CommandRefused refused) {
            return Messages.get(
                    "event.why", sentence(refused.command()), MessageTranslator.translate(refused.reason()));
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

    /** What a command does. */
    private static String sentence(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return Messages.get(
                    "command.move",
                    move.obstacle(),
                    format("%.3f", move.pose().x()),
                    format("%.3f", move.pose().y()),
                    format("%.1f", Math.toDegrees(move.pose().heading())));
        }
        if (command instanceof Command.PlaceObstacle put) {
            return Messages.get("command.put", put.obstacle().id());
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return Messages.get("command.remove", remove.obstacle());
        }
        if (command instanceof Command.SetPlatform platform) {
            return Messages.get(
                    "command.platform",
                    format("%.3f", platform.length()),
                    format("%.3f", platform.width()),
                    format("%.2f", platform.speed()));
        }
        return sensorSentence(command);
    }

    private static String sensorSentence(Command command) {
        if (command instanceof Command.SwitchSensor change) {
            return Messages.get(change.on() ? "command.on" : "command.off", change.sensor());
        }
        if (command instanceof Command.ConfigureSensor tune) {
            return Messages.get(
                    "command.tune",
                    tune.sensor().id(),
                    format("%.2f", tune.sensor().range()),
                    format("%.1f", Math.toDegrees(tune.sensor().cone())));
        }
        if (command instanceof Command.InjectFault inject) {
            return Messages.get("command.inject", inject.sensor(), ReadingText.format(inject.fault()));
        }
        if (command instanceof Command.ClearFault clear) {
            return Messages.get("command.clear", clear.sensor(), ReadingText.format(clear.fault()));
        }
        return Messages.get("command.clearAll", ((Command.ClearFaults) command).sensor());
    }

    private static String format(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
