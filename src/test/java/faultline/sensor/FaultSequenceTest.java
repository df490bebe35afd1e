package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.CpuTime;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class FaultSequenceTest {

    private static final int MOST_COLLECTIONS = 50;

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
    void twoThreadsCanAddToTheSameSequence() throws Exception {
        List<FaultSequence<Integer>> common = new ArrayList<>();
        for (int i = 0; i < 20_000; i++) {
            common.add(FaultSequence.copyOf(List.of(0)));
        }
        AtomicInteger arrived = new AtomicInteger();
        FutureTask<List<FaultSequence<Integer>>> others = new FutureTask<>(() -> addTogether(common, 2, arrived));
        new Thread(others).start();
        List<FaultSequence<Integer>> own = addTogether(common, 1, arrived);
        assertEquals(Collections.nCopies(common.size(), List.of(0, 1, 3)), own);
        assertEquals(Collections.nCopies(common.size(), List.of(0, 2, 3)), others.get());
    }

    /** Adds a fault and then 3 to each sequence, at the same time as another thread. */
    private static List<FaultSequence<Integer>> addTogether(
            List<FaultSequence<Integer>> common, int fault, AtomicInteger arrived) {
        List<FaultSequence<Integer>> made = new ArrayList<>();
        try {
            for (FaultSequence<Integer> sequence : common) {
                arrived.incrementAndGet();
                while (arrived.get() < 2 * (made.size() + 1)) {
                    Thread.yield();
                }
                made.add(sequence.with(fault).with(3));
            }
        } finally {
            // The other thread does not wait for one that has failed.
            arrived.addAndGet(2 * common.size());
        }
        return made;
    }

    /** The motors of all runs of a process start with the same empty sequence. */
    @Test
    void anEmptySequenceDoesNotKeepTheFaultsThatAreAddedToIt() {
        FaultSequence<Object> none = FaultSequence.empty();
        WeakReference<Object> fault = new WeakReference<>(new Object());
        assertEquals(1, none.with(fault.get()).size());
        for (int i = 0; i < MOST_COLLECTIONS && fault.get() != null; i++) {
            System.gc();
        }
        assertNull(fault.get());
        assertEquals(0, none.size());
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

    /** A file may end and begin a fault many times in one tick while others are active. */
    @Test
    void removingAnyFaultOfManyNeedsTheSameTime() {
        CpuTime time = CpuTime.start();
        FaultSequence<Integer> active = FaultSequence.empty();
        for (int i = 0; i < 100_000; i++) {
            active = active.with(i);
        }
        FaultSequence<Integer> before = active;
        for (int i = 0; i < 60_000; i++) {
            active = active.without(99_999).orElseThrow().with(99_999);
            active = active.without(50_000).orElseThrow().with(50_000);
        }
        time.assertBelow(2);
        List<Integer> expected = new ArrayList<>(before);
        expected.remove((Integer) 50_000);
        expected.add(50_000);
        assertEquals(expected, active);
        assertEquals(50_001, before.get(50_001));
        assertEquals(Optional.empty(), active.without(100_000));
    }

    @Test
    void theLastFaultIsRemovedOnce() {
        FaultSequence<Integer> none =
                FaultSequence.<Integer>empty().with(7).without(7).orElseThrow();
        assertEquals(List.of(), none);
        assertEquals(Optional.empty(), none.without(7));
        assertEquals(List.of(8), none.with(8));
    }

    @Test
    void aFaultThatBeginsAfterAVainRemovalCanBeRemoved() {
        FaultSequence<Integer> one = FaultSequence.copyOf(List.of(1));
        assertEquals(Optional.empty(), one.without(2));
        FaultSequence<Integer> two = one.with(2);
        assertEquals(Optional.of(List.of(1)), two.without(2));
        assertEquals(List.of(1, 2), two);
    }
}
