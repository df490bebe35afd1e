package faultline.gui.instrument;

import faultline.engine.record.RunEvent;
import faultline.gui.panel.ReadingText;
import faultline.gui.text.StateText;
import faultline.gui.text.Texts;
import faultline.gui.text.Wordings;
import faultline.world.Command;
import java.util.Locale;

/** The events of a run in words. */
final class EventText {

    private EventText() {
    }

    /** What sort of event it is. */
    static String kind(RunEvent event) {
        if (event instanceof RunEvent.Done done) {
            return Texts.text(isFault(done.command()) ? "event.fault" : "event.command");
        }
        if (event instanceof RunEvent.Diverged) {
            return Texts.text("event.ghost");
        }
        return Texts.text(event instanceof RunEvent.Transition ? "event.transition"
                : event instanceof RunEvent.Refused ? "event.refused" : "event.collision");
    }

    /** Whether something broke: a sensor, or the run into an obstacle. */
    static boolean isWrong(RunEvent event) {
        return event instanceof RunEvent.Collided || event instanceof RunEvent.Done done && done.command() instanceof Command.InjectFault;
    }

    private static boolean isFault(Command command) {
        return command instanceof Command.InjectFault || command instanceof Command.ClearFault || command instanceof Command.ClearFaults;
    }

    static String time(RunEvent event) {
        return number("%.3f", event.time());
    }

    /** What happened. */
    static String sentence(RunEvent event) {
        if (event instanceof RunEvent.Transition move) {
            return Texts.text("diagram.last", StateText.name(move.from()), StateText.name(move.to()),
                    StateText.condition(move.from(), move.to(), move.condition()));
        }
        if (event instanceof RunEvent.Done done) {
            return sentence(done.command());
        }
        if (event instanceof RunEvent.Refused refused) {
            return Texts.text("event.why", sentence(refused.command()), Wordings.text(refused.why()));
        }
        return event instanceof RunEvent.Collided collided ? collision(collided) : Texts.text("event.diverged");
    }

    private static String collision(RunEvent.Collided event) {
        return Texts.text("event.collided", event.collision().obstacle(), number("%.3f", event.collision().point().x()),
                number("%.3f", event.collision().point().y()));
    }

    /** What a command does. */
    private static String sentence(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return Texts.text("command.move", move.obstacle(), number("%.3f", move.pose().x()), number("%.3f", move.pose().y()),
                    number("%.1f", Math.toDegrees(move.pose().heading())));
        }
        if (command instanceof Command.PutObstacle put) {
            return Texts.text("command.put", put.obstacle().id());
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return Texts.text("command.remove", remove.obstacle());
        }
        if (command instanceof Command.SetPlatform platform) {
            return Texts.text("command.platform", number("%.3f", platform.length()), number("%.3f", platform.width()),
                    number("%.2f", platform.speed()));
        }
        return sensorSentence(command);
    }

    private static String sensorSentence(Command command) {
        if (command instanceof Command.SwitchSensor change) {
            return Texts.text(change.on() ? "command.on" : "command.off", change.sensor());
        }
        if (command instanceof Command.TuneSensor tune) {
            return Texts.text("command.tune", tune.sensor().id(), number("%.2f", tune.sensor().range()),
                    number("%.1f", Math.toDegrees(tune.sensor().cone())));
        }
        if (command instanceof Command.InjectFault inject) {
            return Texts.text("command.inject", inject.sensor(), ReadingText.of(inject.fault()));
        }
        if (command instanceof Command.ClearFault clear) {
            return Texts.text("command.clear", clear.sensor(), ReadingText.of(clear.fault()));
        }
        return Texts.text("command.clearAll", ((Command.ClearFaults) command).sensor());
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
