package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.CpuTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FaultSequenceTest {

    @Test
    void everyCopyHasTheFaultsOfAListWithTheSameChanges() {
        Random random = new Random(5);
        List<FaultSequence<Integer>> sequences = new ArrayList<>(List.of(FaultSequence.empty()));
        List<List<Integer>> lists = new ArrayList<>(List.of(List.of()));
        for (int i = 0; i < 3000; i++) {
            // Mostly the newest one, sometimes an older one, whose storage others continue to use.
            int base = random.nextInt(4) > 0 ? sequences.size() - 1 : random.nextInt(sequences.size());
            int fault = random.nextInt(6);
            List<Integer> expected = new ArrayList<>(lists.get(base));
            if (random.nextBoolean()) {
                expected.add(fault);
                sequences.add(sequences.get(base).with(fault));
            } else if (expected.remove((Integer) fault)) {
                sequences.add(sequences.get(base).without(fault).orElseThrow());
            } else {
                assertEquals(Optional.empty(), sequences.get(base).without(fault));
                continue;
            }
            lists.add(expected);
        }
        assertEquals(lists, sequences);
        assertEquals(sequences, lists);
    }

    @Test
    void aSequenceCannotBeChangedAndIsItsOwnCopy() {
        FaultSequence<Fault> one = FaultSequence.copyOf(List.of(new Fault.Dead()));
        assertSame(one, FaultSequence.copyOf(one));
        assertThrows(UnsupportedOperationException.class, () -> one.add(new Fault.Dead()));
        assertThrows(UnsupportedOperationException.class, () -> one.remove(0));
        assertThrows(IndexOutOfBoundsException.class, () -> one.get(1));
        assertThrows(
                IndexOutOfBoundsException.class,
                () -> one.without(new Fault.Dead()).orElseThrow().get(0));
    }

    @Test
    void faultsThatBeginAndEndInTurnNeedTimeInProportionToTheirNumber() {
        CpuTime time = CpuTime.start();
        FaultSequence<Integer> active = FaultSequence.empty();
        for (int i = 0; i < 300_000; i++) {
            active = active.with(i);
            if (i >= 100_000) {
                active = active.without(i - 100_000).orElseThrow();
            }
        }
        assertEquals(200_000, active.get(0));
        assertEquals(100_000, active.size());
        time.assertBelow(2);
    }
}
