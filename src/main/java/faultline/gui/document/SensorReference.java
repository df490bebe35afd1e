package faultline.gui.document;

import faultline.world.Command;
import faultline.world.Command.CommandCases;
import java.util.Optional;
import java.util.function.Function;

/** Finds the sensor that a command is about. */
public final class SensorReference {

    private static final CommandCases<Optional<String>> FINDER = new CommandCases<>(
            switchSensor -> Optional.of(switchSensor.sensor()),
            configureSensor -> Optional.of(configureSensor.sensor().id()),
            injectFault -> Optional.of(injectFault.sensor()),
            clearFault -> Optional.of(clearFault.sensor()),
            clearFaults -> Optional.of(clearFaults.sensor()),
            none(),
            none(),
            none(),
            none(),
            none(),
            none(),
            none(),
            none());

    private SensorReference() {}

    private static <C> Function<C, Optional<String>> none() {
        return command -> Optional.empty();
    }

    /** Returns the id of the sensor that a command is about; empty if it is about something else. */
    public static Optional<String> in(Command command) {
        return command.match(FINDER);
    }
}
