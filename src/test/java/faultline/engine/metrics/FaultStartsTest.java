package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Command.ClearFault;
import faultline.world.Command.ClearFaults;
import faultline.world.Command.ClearMotorFault;
import faultline.world.Command.ClearMotorFaults;
import faultline.world.Command.InjectFault;
import faultline.world.Command.InjectMotorFault;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Faults that a command of their tick ends never act. A tick is 10 ms. */
class FaultStartsTest {

    private static final Fault BIAS = new Fault.Bias(0.1);
    private static final MotorFault OFF = new MotorFault.NoDrive();
    private static final Command LEFT = new InjectFault("left", BIAS);
    private static final Command MOTORS = new InjectMotorFault(MotorSide.LEFT, OFF);

    private static TimedCommand at(double time, Command command) {
        return new TimedCommand(time, command);
    }

    private static SimulationSetup setup(TimedCommand... timeline) {
        return SimulationSetup.of(new WorldSpec(4, 3, true, 0, List.of()), new Pose(2, 1.5, 0))
                .withController(new ControllerSpec.None())
                .withTimeline(List.of(timeline));
    }

    /** Returns the indices of the commands of one tick that begin a fault. */
    private static List<Integer> inOneTick(Command... commands) {
        TimedCommand[] timeline = new TimedCommand[commands.length];
        Arrays.setAll(timeline, i -> at(5.001 + 0.0001 * i, commands[i]));
        return FaultStarts.of(setup(timeline)).stream()
                .map(Arrays.asList(timeline)::indexOf)
                .toList();
    }

    @Test
    void aFaultThatARepairOfItsTickEndsDoesNotBegin() {
        assertEquals(List.of(), inOneTick(LEFT, new ClearFault("left", BIAS)));
        assertEquals(List.of(), inOneTick(LEFT, LEFT, new ClearFaults("left")));
        assertEquals(List.of(), inOneTick(MOTORS, new ClearMotorFault(MotorSide.LEFT, OFF)));
        assertEquals(List.of(), inOneTick(MOTORS, new ClearMotorFaults(MotorSide.LEFT)));
    }

    @Test
    void aRepairOfAnotherFaultOrBeforeItEndsNone() {
        assertEquals(List.of(0), inOneTick(LEFT, new ClearFault("left", new Fault.Bias(0.2))));
        assertEquals(List.of(0), inOneTick(LEFT, new ClearFaults("right")));
        assertEquals(List.of(0), inOneTick(MOTORS, new ClearMotorFaults(MotorSide.RIGHT)));
        assertEquals(List.of(1), inOneTick(new ClearFaults("left"), LEFT));
        assertEquals(List.of(2), inOneTick(LEFT, new ClearFault("left", BIAS), LEFT));
    }

    @Test
    void aRepairOfOneFaultEndsOne() {
        assertEquals(List.of(1), inOneTick(LEFT, LEFT, new ClearFault("left", BIAS)));
    }

    @Test
    void aRepairEndsTheOldestOfEqualFaults() {
        List<TimedCommand> timeline = List.of(at(10, LEFT), at(20, LEFT), at(20, new ClearFault("left", BIAS)));
        assertEquals(timeline.subList(0, 2), FaultStarts.of(setup(timeline.toArray(new TimedCommand[0]))));
        List<TimedCommand> motors =
                List.of(at(10, MOTORS), at(20, MOTORS), at(20, new ClearMotorFault(MotorSide.LEFT, OFF)));
        assertEquals(motors.subList(0, 2), FaultStarts.of(setup(motors.toArray(new TimedCommand[0]))));
    }

    @Test
    void equalFaultsOneAfterTheOtherBeginInAnyOrderOfTheFile() {
        ClearFault repair = new ClearFault("left", BIAS);
        TimedCommand[] first = {at(10, LEFT), at(20, repair), at(20, LEFT), at(30, repair)};
        TimedCommand[] second = {at(20, LEFT), at(30, repair), at(10, LEFT), at(20, repair)};
        assertEquals(List.of(first[0], first[2]), FaultStarts.of(setup(first)));
        assertEquals(List.of(first[0], first[2]), FaultStarts.of(setup(second)));
    }

    private static Command randomCommand(Random random) {
        String sensor = random.nextBoolean() ? "left" : "right";
        Fault fault = new Fault.Bias(random.nextInt(2));
        return switch (random.nextInt(9)) {
            case 0 -> new ClearFaults(sensor);
            case 1, 2, 3 -> new ClearFault(sensor, fault);
            default -> new InjectFault(sensor, fault);
        };
    }

    /** Returns the commands that begin faults, found with a list of the active ones, oldest first. */
    private static List<TimedCommand> startsInList(List<TimedCommand> timeline) {
        List<TimedCommand> begun = new ArrayList<>(timeline);
        begun.removeIf(timed -> !(timed.command() instanceof InjectFault));
        List<TimedCommand> active = new ArrayList<>();
        for (TimedCommand timed : timeline) {
            List<TimedCommand> ended = new ArrayList<>(active);
            if (timed.command() instanceof ClearFault repair) {
                ended.removeIf(start -> !start.command().equals(new InjectFault(repair.sensor(), repair.fault())));
                ended = ended.subList(0, Math.min(1, ended.size()));
            } else if (timed.command() instanceof ClearFaults repair) {
                ended.removeIf(
                        start -> !((InjectFault) start.command()).sensor().equals(repair.sensor()));
            } else {
                ended.clear();
                active.add(timed);
            }
            active.removeAll(ended);
            ended.removeIf(start -> Math.ceil(start.time()) != Math.ceil(timed.time()));
            begun.removeAll(ended);
        }
        return begun;
    }

    @Test
    void theStartsAreThoseThatAListOfActiveFaultsShows() {
        Random random = new Random(11);
        for (int run = 0; run < 300; run++) {
            List<TimedCommand> timeline = new ArrayList<>();
            for (int i = 1; i <= 40; i++) {
                // No two commands are equal; eight are in each tick, which is as long as a second here.
                timeline.add(at(0.125 * i, randomCommand(random)));
            }
            SimulationSetup setup = setup(timeline.toArray(new TimedCommand[0])).withTick(1);
            assertEquals(startsInList(timeline), FaultStarts.of(setup));
        }
    }

    @Test
    @Timeout(10)
    void theTimeIsProportionalToTheNumberOfCommands() {
        int count = 100_000;
        List<TimedCommand> timeline = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            timeline.add(at(0.01 * i, new ClearFaults("left")));
            timeline.add(at(0.01 * count + 5, new ClearFault("left", new Fault.Bias(1e-5 * (i + 1)))));
        }
        assertEquals(List.of(), FaultStarts.of(setup(timeline.toArray(new TimedCommand[0]))));
    }

    @Test
    void aRepairInALaterTickEndsNoneOfThem() {
        List<TimedCommand> timeline = List.of(at(5.011, new ClearFaults("left")), at(5.001, LEFT));
        assertEquals(List.of(timeline.get(1)), FaultStarts.of(setup(timeline.toArray(new TimedCommand[0]))));
    }

    @Test
    void theDelayAndTheClockStartAtTheFirstFaultThatLasts() {
        SimulationSetup setup = setup(
                        at(0.001, LEFT),
                        at(0.004, new ClearFaults("left")),
                        at(0.5, new InjectFault("right", new Fault.Dead())),
                        at(0.9, MOTORS),
                        at(0.9, new ClearMotorFaults(MotorSide.LEFT)))
                .withController(ControllerSpec.WallFollowing.DEFAULT)
                .withDuration(1);
        DiagnosisMetrics diagnosis = new DiagnosisMetrics(setup);
        HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(diagnosis));
        assertEquals(0.01, diagnosis.detectionDelay().orElseThrow(), 1e-9);
        assertEquals(0.5, CarryOnMetrics.faultTimes(setup).max().orElseThrow());
    }
}
