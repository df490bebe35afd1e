package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What undoes the change of a sensor's faults, against lists of faults that are changed one by one. */
class EventEffectsTest {

    private static final String SENSOR = "front";

    private final Random random = new Random(7);

    private Command randomEvent() {
        Fault fault = randomFault();
        return switch (random.nextInt(7)) {
            case 0 -> new Command.ClearFaults(SENSOR);
            case 1, 2 -> new Command.ClearFault(SENSOR, fault);
            default -> new Command.InjectFault(SENSOR, fault);
        };
    }

    private Fault randomFault() {
        return new Fault.Bias(random.nextInt(3));
    }

    private static void execute(List<Fault> faults, Command event) {
        if (event instanceof Command.InjectFault inject) {
            faults.add(inject.fault());
        } else if (event instanceof Command.ClearFault clear) {
            faults.remove(clear.fault());
        } else {
            faults.clear();
        }
    }

    private static CommandResult executed(List<Fault> faults, Command event) {
        List<Command> inverse = Stream.concat(
                        Stream.of(new Command.ClearFaults(SENSOR)),
                        faults.stream().map(fault -> (Command) new Command.InjectFault(SENSOR, fault)))
                .toList();
        execute(faults, event);
        return new CommandResult.Executed(1, event, inverse);
    }

    private static List<Fault> sorted(List<Fault> faults) {
        return faults.stream().sorted(Comparator.comparing(Fault::toString)).toList();
    }

    @Test
    void otherEventsKeepTheirEffectAndWithoutThemTheOrderReturns() {
        for (int trial = 0; trial < 10_000; trial++) {
            List<Fault> without = new ArrayList<>(IntStream.range(0, random.nextInt(4))
                    .mapToObj(i -> randomFault())
                    .toList());
            List<Fault> with = new ArrayList<>(without);
            CommandResult event = executed(with, randomEvent());
            List<Command> others = IntStream.range(0, random.nextInt(4))
                    .mapToObj(i -> randomEvent())
                    .toList();
            others.forEach(other -> execute(without, other));
            others.forEach(other -> execute(with, other));
            EventEffects.undo(event, others).forEach(step -> execute(with, step));
            String message = event + " before " + others;
            assertEquals(sorted(without), sorted(with), message);
            if (others.isEmpty()) {
                assertEquals(without, with, message);
            }
        }
    }
}
