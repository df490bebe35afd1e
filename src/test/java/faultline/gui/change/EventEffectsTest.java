package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.WorldSpec;
import java.lang.management.ManagementFactory;
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
    private static final SimulationSetup SETUP =
            SimulationSetup.of(new WorldSpec(6, 4, true, 0, List.of()), new Pose(3, 2, 0));

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

    /** The results come from another run, so what undoes the events there is of no use. */
    @Test
    void whatUndoesTheEventsOfARunIsWhatTheRunItselfReturns() {
        for (int trial = 0; trial < 100; trial++) {
            List<TimedCommand> timeline = IntStream.range(0, 20)
                    .mapToObj(
                            i -> new TimedCommand(random.nextInt(10) / 100.0, i < 2 ? settings() : randomEventOfAny()))
                    .toList();
            SimulationSetup setup = SETUP.withTimeline(timeline);
            List<CommandResult> executed = execute(setup);
            List<CommandResult> ofOtherRun = executed.stream()
                    .<CommandResult>map(result ->
                            new CommandResult.Executed(result.tick(), result.command(), List.of(randomEvent())))
                    .toList();
            EventStates states = new EventStates(setup);
            assertEquals(executed, ofOtherRun.stream().map(states::execute).toList(), timeline.toString());
        }
    }

    /** A copy of the faults for each of them would take more than 1 GB. */
    @Test
    void manyFaultsOfASensorTakeMemoryInProportionToTheirNumber() {
        int faults = 20_000;
        List<TimedCommand> timeline = IntStream.range(0, faults)
                .mapToObj(i -> new TimedCommand(i / 100.0, new Command.InjectFault(SENSOR, randomFault())))
                .toList();
        SimulationSetup setup = SETUP.withTimeline(timeline);
        List<CommandResult> executed = IntStream.range(0, faults)
                .<CommandResult>mapToObj(
                        i -> new CommandResult.Executed(i, timeline.get(i).command(), List.of()))
                .toList();
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = thread.getCurrentThreadAllocatedBytes();
        EventStates states = new EventStates(setup);
        List<CommandResult> present = executed.stream().map(states::execute).toList();
        assertEquals(faults, TimelineEvents.in(present).size());
        long bytes = thread.getCurrentThreadAllocatedBytes() - before;
        assertTrue(bytes < 3000L * faults, bytes + " bytes");
        assertEquals(2 * faults, present.get(faults - 1).inverse().size());
    }

    private List<CommandResult> execute(SimulationSetup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            List<CommandResult> executed = new ArrayList<>();
            for (int i = 0; i < 40; i++) {
                CommandResult result = simulation.execute(randomEventOfAny());
                if (result.refusal().isEmpty() && TimelineEvents.isEvent(result.command())) {
                    executed.add(result);
                }
                if (i % 3 == 0) {
                    simulation.tick();
                }
            }
            return executed;
        }
    }

    /** Returns settings of the sensor, which contain its switch. */
    private Command settings() {
        SensorSpec sensor = SETUP.robot().sensor(SENSOR).orElseThrow();
        return new Command.ConfigureSensor(sensor.withOn(random.nextBoolean()));
    }

    private Command randomEventOfAny() {
        MotorFault weak = new MotorFault.Weak(0.5 + random.nextInt(2) / 10.0);
        return switch (random.nextInt(8)) {
            case 0 -> new Command.SwitchSensor(SENSOR, random.nextBoolean());
            case 1 -> new Command.InjectMotorFault(MotorSide.LEFT, weak);
            case 2 -> new Command.ClearMotorFault(MotorSide.LEFT, weak);
            case 3 -> new Command.ClearMotorFaults(MotorSide.LEFT);
            default -> randomEvent();
        };
    }
}
