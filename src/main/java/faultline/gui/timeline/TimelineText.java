package faultline.gui.timeline;

import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.theme.UiText;
import faultline.world.Command;

/** Describes the items of the time line in the user's language. */
public final class TimelineText {

    private TimelineText() {}

    /** Returns a short name without the sensor or motors: the fault, or what the command does. */
    static String label(TimelineItem item) {
        if (item.command() instanceof Command.InjectFault injected) {
            return FaultText.format(injected.fault());
        }
        if (item.command() instanceof Command.InjectMotorFault injected) {
            return FaultText.format(injected.fault());
        }
        return item.command() instanceof Command.SwitchSensor switched && !switched.on()
                ? Messages.get("timeline.off")
                : CommandText.format(item.command());
    }

    /** Returns the label with its sensor or motors. */
    static String name(TimelineItem item) {
        return item.isInterval() ? item.lane().label() + ": " + label(item) : label(item);
    }

    /** Returns the name, or a short one for a change of the controller, whose name has all of its settings. */
    public static String title(TimelineItem item) {
        return item.command() instanceof Command.ConfigureController ? Messages.get("timeline.controller") : name(item);
    }

    /** Returns the title of a dialog in which an item can be changed; a fault may become another one there. */
    static String dialogTitle(TimelineItem item) {
        if (item.command() instanceof Command.MoveObstacle move) {
            // The dialog shows where to.
            return Messages.get("timeline.move.title", UiText.shortName(move.obstacle()));
        }
        boolean fault =
                item.command() instanceof Command.InjectFault || item.command() instanceof Command.InjectMotorFault;
        return fault ? Messages.get("faults.kind") : title(item);
    }

    /** Returns the name and the times, given the length of a tick, seconds. */
    static String description(TimelineItem item, double dt) {
        return name(item) + ", " + times(item, dt);
    }

    /** Returns what happens at the start of an item. */
    static String start(TimelineItem item) {
        return item.isInterval() ? Messages.get("timeline.begins", name(item)) : title(item);
    }

    /** Returns what happens at the end of an interval. */
    static String end(TimelineItem item) {
        return Messages.get("timeline.ends", name(item));
    }

    /** Returns the times, for example "20.00 – 40.00 s", given the length of a tick, seconds. */
    static String times(TimelineItem item, double dt) {
        String start = NumberText.seconds(item.start(), dt);
        if (!item.isInterval()) {
            return start + " s";
        }
        return item.isOpen()
                ? Messages.get("timeline.from", start)
                : start + " – " + NumberText.seconds(item.end(), dt) + " s";
    }
}
