package faultline.gui.timeline;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.List;

/**
 * An item of the time line: a fault or a sensor that is switched off, for an interval, or a command at one moment.
 * Times are in seconds; the end is infinite if it lasts to the end of the run, and equal to the start for a moment.
 */
public record TimelineItem(Command command, double start, double end) {

    /** Returns an item that lasts to the end of the run, if its command can last, or else is over at once. */
    public static TimelineItem from(Command command, double start) {
        boolean lasts = !CommandRole.of(command).endings().isEmpty();
        return new TimelineItem(command, start, lasts ? Double.POSITIVE_INFINITY : start);
    }

    private CommandRole role() {
        return CommandRole.of(command);
    }

    /** Returns whether this is an interval, a bar and not a mark. */
    public boolean isInterval() {
        return !role().endings().isEmpty();
    }

    /** Returns whether this is an interval that lasts to the end of the run. */
    public boolean isOpen() {
        return Double.isInfinite(end);
    }

    public Lane lane() {
        return role().lane();
    }

    /**
     * Returns the colours of this item's sensor, which has the given index, or motors; grey for a sensor that is
     * switched off.
     */
    SensorColours colours(Palette palette, int sensor) {
        if (role().effect() == CommandRole.ChangedProperty.SWITCH) {
            return new SensorColours(palette.muted(), palette.muted());
        }
        return lane() instanceof Lane.SensorLane
                ? palette.sensorColours(sensor)
                : new SensorColours(palette.robot(), palette.robotOutline());
    }

    /** Returns the colours of this item on a robot; those of its first sensor for one that it lacks. */
    public SensorColours colours(Palette palette, RobotSpec robot) {
        return colours(palette, lane() instanceof Lane.SensorLane sensor ? Math.max(0, robot.indexOf(sensor.id())) : 0);
    }

    /** Returns this item with other times; those of a moment are equal. */
    TimelineItem withTimes(double newStart, double newEnd) {
        return new TimelineItem(command, newStart, isInterval() ? newEnd : newStart);
    }

    /** Returns this item in another lane, or an equal one if it cannot be there. */
    TimelineItem inLane(Lane other) {
        return new TimelineItem(role().inLane().apply(other), start, end);
    }

    /** Returns the commands of this item: one, or two if it ends before the run does. */
    List<TimedCommand> commands() {
        TimedCommand first = new TimedCommand(start, command);
        return isInterval() && !isOpen()
                ? List.of(first, new TimedCommand(end, endings().get(0)))
                : List.of(first);
    }

    /** Returns the commands that can end this interval, first the one that is written; empty for a moment. */
    List<Command> endings() {
        return role().endings();
    }

    /** Returns whether this is a fault that another item also starts, and both are active at some time. */
    boolean repeats(TimelineItem other) {
        return role().isFaultStart() && command.equals(other.command) && start < other.end && other.start < end;
    }

    /** Returns whether a command ends this interval and all others of the same lane and effect. */
    boolean isEndedWithOthers(Command ending) {
        return endings().contains(ending)
                && (role().effect() == CommandRole.ChangedProperty.SWITCH
                        || !endings().get(0).equals(ending));
    }
}
