package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.CpuTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The ends of equal faults, against a list of faults that is searched from its start. */
class OldestFirstTest {

    private static final Fault BIAS = new Fault.Bias(0.1);

    /** A fault in the list and the number of its beginning. */
    private record Begun(Fault fault, int number) {}

    private static Optional<Integer> endFirst(List<Begun> active, Fault fault) {
        for (int i = 0; i < active.size(); i++) {
            if (active.get(i).fault().equals(fault)) {
                return Optional.of(active.remove(i).number());
            }
        }
        return Optional.empty();
    }

    @Test
    void ofEqualFaultsTheFirstInAListEndsFirst() {
        Random random = new Random(3);
        for (int faults = 1; faults <= 4; faults++) {
            OldestFirst<Fault, Integer> tested = new OldestFirst<>();
            List<Begun> list = new ArrayList<>();
            for (int i = 0; i < 5000; i++) {
                Fault fault = new Fault.Bias(random.nextInt(faults));
                int change = random.nextInt(20);
                if (change == 0) {
                    List<Integer> expected = list.stream().map(Begun::number).toList();
                    list.clear();
                    assertEquals(expected, tested.endAll().stream().sorted().toList());
                } else if (change < 10) {
                    list.add(new Begun(fault, i));
                    tested.begin(fault, i);
                } else {
                    assertEquals(endFirst(list, fault), tested.end(fault));
                }
            }
        }
    }

    @Test
    void theOldestOfTwoEqualFaultsEndsFirst() {
        OldestFirst<Fault, String> faults = new OldestFirst<>();
        faults.begin(BIAS, "10 s");
        faults.begin(new Fault.Bias(0.1), "20 s");
        faults.begin(new Fault.Bias(0.2), "15 s");
        assertEquals(Optional.of("10 s"), faults.end(BIAS));
        assertEquals(Optional.of("20 s"), faults.end(BIAS));
        assertEquals(Optional.empty(), faults.end(BIAS));
        assertEquals(List.of("15 s"), faults.endAll());
        assertEquals(List.of(), faults.endAll());
    }

    /** A file may repair a sensor in each tick after it had many faults. */
    @Test
    void theEndOfAllNeedsTimeInProportionToTheFaultsThatAreActive() {
        CpuTime time = CpuTime.start();
        OldestFirst<Integer, Integer> faults = new OldestFirst<>();
        for (int i = 0; i < 100_000; i++) {
            faults.begin(i, i);
        }
        assertEquals(100_000, faults.endAll().size());
        for (int i = 0; i < 100_000; i++) {
            faults.begin(i, i);
            assertEquals(List.of(i), faults.endAll());
        }
        time.assertBelow(2);
    }
}
