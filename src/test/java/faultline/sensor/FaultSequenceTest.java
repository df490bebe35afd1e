package faultline.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.CpuTime;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

    /** A fault whose hash, which is computed within each change of a sequence, can start another change. */
    private static final class HashedFault {
        private Optional<Thread> other = Optional.empty();

        @Override
        public int hashCode() {
            other.filter(thread -> thread.getState() == Thread.State.NEW).ifPresent(HashedFault::startAndAwaitRest);
            return 1;
        }

        @Override
        public boolean equals(Object object) {
            return this == object;
        }

        /** Starts a thread and waits until it waits or has ended. */
        private static void startAndAwaitRest(Thread thread) {
            thread.start();
            while (thread.getState() == Thread.State.RUNNABLE) {
                Thread.onSpinWait();
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"false, false", "false, true", "true, false", "true, true"})
    void aThreadCanChangeASequenceWhileAnotherOneChangesIt(boolean removes, boolean otherRemoves) throws Exception {
        HashedFault hashed = new HashedFault();
        List<Object> faults = removes ? List.of(0, hashed) : List.of(0);
        FaultSequence<Object> common = FaultSequence.copyOf(faults);
        assertEquals(Optional.empty(), common.without(1), "the first removal computes all hashes");
        FutureTask<List<Object>> others =
                new FutureTask<>(() -> (otherRemoves ? common.without(0).orElseThrow() : common.with(2)).with(3));
        hashed.other = Optional.of(new Thread(others));
        FaultSequence<Object> own = (removes ? common.without(hashed).orElseThrow() : common.with(hashed)).with(4);
        assertEquals(removes ? List.of(0, 4) : List.of(0, hashed, 4), own);
        assertEquals(expected(faults, otherRemoves), others.get(1, TimeUnit.MINUTES));
        assertEquals(faults, common);
    }

    private static List<Object> expected(List<Object> faults, boolean removes) {
        List<Object> expected = new ArrayList<>(faults);
        if (removes) {
            expected.remove((Object) 0);
        } else {
            expected.add(2);
        }
        expected.add(3);
        return expected;
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
