package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** When the timeline ends the faults that are active. */
class TimelineEventsTest {

    private static final double NEVER = Double.POSITIVE_INFINITY;
    private static final MotorFault WEAK = new MotorFault.Weak(0.5);
    private static final Command LEFT_WEAK = new Command.InjectMotorFault(MotorSide.LEFT, WEAK);
    private static final Command LEFT_DEAD = new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.NoDrive());
    private static final Command LEFT_WEAK_ENDS = new Command.ClearMotorFault(MotorSide.LEFT, WEAK);

    private static TimedCommand at(double time, Command command) {
        return new TimedCommand(time, command);
    }

    @Test
    void aFaultEndsAtItsNextRepair() {
        List<TimedCommand> timeline =
                List.of(at(8, LEFT_WEAK_ENDS), at(3, LEFT_WEAK_ENDS), at(5, LEFT_WEAK), at(2, LEFT_WEAK));
        assertEquals(List.of(3.0), TimelineEvents.ends(List.of(LEFT_WEAK), timeline, 2));
        assertEquals(List.of(8.0), TimelineEvents.ends(List.of(LEFT_WEAK), timeline, 5));
        assertEquals(List.of(NEVER), TimelineEvents.ends(List.of(LEFT_WEAK), timeline, 8));
    }

    @Test
    void theOldestOfEqualFaultsEndsFirstAndALaterOneNotBeforeThem() {
        List<TimedCommand> timeline =
                List.of(at(3, LEFT_WEAK), at(4, LEFT_WEAK_ENDS), at(5, LEFT_WEAK_ENDS), at(6, LEFT_WEAK_ENDS));
        assertEquals(
                List.of(4.0, NEVER, 5.0), TimelineEvents.ends(List.of(LEFT_WEAK, LEFT_DEAD, LEFT_WEAK), timeline, 1));
    }

    @Test
    void aRepairOfAllFaultsEndsEachThatIsLeft() {
        List<TimedCommand> timeline = List.of(
                at(2, LEFT_WEAK_ENDS),
                at(3, LEFT_WEAK),
                at(4, new Command.ClearMotorFaults(MotorSide.LEFT)),
                at(9, LEFT_WEAK_ENDS));
        assertEquals(List.of(2.0, 4.0), TimelineEvents.ends(List.of(LEFT_WEAK, LEFT_DEAD), timeline, 1));
    }

    private static Command randomEvent(Random random) {
        return switch (random.nextInt(8)) {
            case 0 -> new Command.ClearMotorFaults(MotorSide.LEFT);
            case 1, 2 -> LEFT_WEAK_ENDS;
            case 3 -> new Command.ClearMotorFault(MotorSide.LEFT, new MotorFault.NoDrive());
            case 4, 5 -> LEFT_DEAD;
            default -> LEFT_WEAK;
        };
    }

    /** Returns the ends of faults, found with a list of the active ones, oldest first. */
    private static List<Double> endsInList(List<Command> faults, List<TimedCommand> timeline) {
        // The last one is for later faults.
        List<Double> ends = new ArrayList<>(Collections.nCopies(faults.size() + 1, NEVER));
        List<Command> active = new ArrayList<>(faults);
        List<Integer> places =
                new ArrayList<>(IntStream.range(0, faults.size()).boxed().toList());
        for (TimedCommand event : timeline) {
            boolean endsAll = event.command() instanceof Command.ClearMotorFaults;
            if (event.command() instanceof Command.InjectMotorFault) {
                active.add(event.command());
                places.add(faults.size());
            }
            int first = event.command() instanceof Command.ClearMotorFault end
                    ? active.indexOf(new Command.InjectMotorFault(end.motor(), end.fault()))
                    : -1;
            int from = endsAll ? 0 : Math.max(0, first);
            int to = endsAll ? active.size() : first + 1;
            places.subList(from, to).forEach(place -> ends.set(place, event.time()));
            places.subList(from, to).clear();
            active.subList(from, to).clear();
        }
        return ends.subList(0, faults.size());
    }

    @Test
    void theEndsAreThoseOfAListWhoseFirstOfEqualFaultsEnds() {
        Random random = new Random(6);
        for (int run = 0; run < 1000; run++) {
            List<Command> faults = Stream.generate(() -> random.nextBoolean() ? LEFT_WEAK : LEFT_DEAD)
                    .limit(random.nextInt(5))
                    .toList();
            List<TimedCommand> timeline = IntStream.range(1, 15)
                    .mapToObj(time -> at(time, randomEvent(random)))
                    .toList();
            assertEquals(endsInList(faults, timeline), TimelineEvents.ends(faults, timeline, 0));
        }
    }

    /** One fault lasts while 30 000 later ones overlap. */
    @Test
    void theTimeThatTheEndsTakeIsInProportionToTheEvents() {
        CpuTime time = CpuTime.start();
        List<TimedCommand> timeline = new ArrayList<>();
        for (int i = 1; i <= 60_000; i++) {
            timeline.add(at(i, LEFT_WEAK));
            timeline.add(at(i + 30_000.5, LEFT_WEAK_ENDS));
        }
        assertEquals(List.of(NEVER), TimelineEvents.ends(List.of(LEFT_DEAD), timeline, 0));
        time.assertBelow(2);
    }

    @Test
    void eventsOfOthersEndNothing() {
        Fault stuck = new Fault.Stuck(0.4);
        List<TimedCommand> timeline = List.of(
                at(2, new Command.ClearMotorFault(MotorSide.RIGHT, WEAK)),
                at(3, new Command.ClearMotorFaults(MotorSide.RIGHT)),
                at(4, new Command.ClearFaults("left")),
                at(5, new Command.SwitchSensor("front", false)),
                at(6, new Command.SetPlatform(0.2, 0.2, 0.3)),
                at(7, new Command.ClearFault("front", stuck)));
        assertEquals(List.of(NEVER), TimelineEvents.ends(List.of(LEFT_WEAK), timeline, 0));
        assertEquals(List.of(7.0), TimelineEvents.ends(List.of(new Command.InjectFault("front", stuck)), timeline, 0));
        assertEquals(List.of(), TimelineEvents.ends(List.of(), timeline, 0));
    }

    @Test
    void aDifferenceHasWhatIsMissingAsOftenAsItIsInItsOrder() {
        assertEquals(
                List.of("c", "a", "a"),
                TimelineEvents.difference(List.of("a", "c", "b", "a", "a"), List.of("b", "a", "d", "b")));
        assertEquals(List.of(), TimelineEvents.difference(List.of("a"), List.of("a", "a")));
        assertEquals(List.of("a"), TimelineEvents.difference(List.of("a"), List.of()));
    }

    /** An undo compares the whole timeline with the one before, which may have many thousand commands. */
    @Test
    void theComparisonsOfADifferenceAreInProportionToTheLists() {
        AtomicInteger comparisons = new AtomicInteger();
        List<Counted> list = IntStream.range(0, 1000)
                .mapToObj(i -> new Counted(i, comparisons))
                .toList();
        List<Counted> reversed = new ArrayList<>(list);
        Collections.reverse(reversed);
        assertEquals(List.of(list.get(999)), TimelineEvents.difference(list, reversed.subList(1, 1000)));
        assertTrue(comparisons.get() < 5000, "comparisons: " + comparisons);
    }

    /** A number that counts how often it is compared. */
    private record Counted(int number, AtomicInteger comparisons) {
        @Override
        public boolean equals(Object other) {
            comparisons.incrementAndGet();
            return other instanceof Counted that && that.number == number;
        }

        @Override
        public int hashCode() {
            return number;
        }
    }
}
