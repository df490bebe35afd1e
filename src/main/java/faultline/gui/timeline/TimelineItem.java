package faultline.gui.timeline;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import faultline.world.Command;
import java.util.List;

/**
 * An item of the time line: a fault or a sensor that is switched off, for an interval, or a command at one moment.
 *
 * @param command the command at the start
 * @param start the start, seconds
 * @param end the end, seconds; infinite if it lasts to the end of the run, equal to the start for a moment
 */
public record TimelineItem(Command command, double start, double end) {

    /** Returns an item that lasts to the end of the run, if its command can last, or else is over at once. */
    static TimelineItem from(Command command, double start) {
        return new TimelineItem(command, start, isLasting(command) ? Double.POSITIVE_INFINITY : start);
    }

    private static boolean isLasting(Command command) {
        return command instanceof Command.InjectFault
                || command instanceof Command.InjectMotorFault
                || command instanceof Command.SwitchSensor switched && !switched.on();
    }

    /** Returns whether this is an interval, a bar and not a mark. */
    public boolean isInterval() {
        return isLasting(command);
    }

    /** Returns whether this is an interval that lasts to the end of the run. */
    public boolean isOpen() {
        return Double.isInfinite(end);
    }

    /** Returns the lane of this item. */
    public Lane lane() {
        return Lane.of(command);
    }

    /**
     * Returns the colours of this item's sensor, which has the given index, or motors; grey for a sensor that is
     * switched off.
     */
    public SensorColours colours(Palette palette, int sensor) {
        if (command instanceof Command.SwitchSensor) {
            return new SensorColours(palette.muted(), palette.muted());
        }
        return lane() instanceof Lane.OfSensor
                ? palette.sensorColours(sensor)
                : new SensorColours(palette.robot(), palette.robotOutline());
    }

    /** Returns this item with other times; those of a moment are equal. */
    TimelineItem withTimes(double newStart, double newEnd) {
        return new TimelineItem(command, newStart, isInterval() ? newEnd : newStart);
    }

    /** Returns this item with another command at its start. */
    TimelineItem withCommand(Command other) {
        return new TimelineItem(other, start, end);
    }

    /** Returns this item in another lane, or the same item if it cannot be there. */
    TimelineItem inLane(Lane other) {
        if (other instanceof Lane.OfSensor sensor && command instanceof Command.InjectFault inject) {
            return withCommand(new Command.InjectFault(sensor.id(), inject.fault()));
        }
        if (other instanceof Lane.OfSensor sensor && command instanceof Command.SwitchSensor switched) {
            return withCommand(new Command.SwitchSensor(sensor.id(), switched.on()));
        }
        return other instanceof Lane.OfMotors motors && command instanceof Command.InjectMotorFault inject
                ? withCommand(new Command.InjectMotorFault(motors.side(), inject.fault()))
                : this;
    }

    /** Returns the commands of this item: one, or two if it ends before the run does. */
    List<TimedCommand> commands() {
        TimedCommand first = new TimedCommand(start, command);
        return isInterval() && !isOpen() ? List.of(first, new TimedCommand(end, endCommand())) : List.of(first);
    }

    private Command endCommand() {
        if (command instanceof Command.InjectFault inject) {
            return new Command.ClearFault(inject.sensor(), inject.fault());
        }
        return command instanceof Command.InjectMotorFault inject
                ? new Command.ClearMotorFault(inject.motor(), inject.fault())
                : new Command.SwitchSensor(((Command.SwitchSensor) command).sensor(), true);
    }

    /** Returns whether a later command ends this interval. */
    boolean endsWith(Command later) {
        boolean all = later instanceof Command.ClearFaults && command instanceof Command.InjectFault
                || later instanceof Command.ClearMotorFaults;
        return later.equals(endCommand()) || all && Lane.of(later).equals(lane());
    }
}
