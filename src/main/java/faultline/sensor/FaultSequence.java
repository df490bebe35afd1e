package faultline.sensor;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.RandomAccess;

/**
 * Active faults, oldest first: an immutable list whose copy with one more fault shares its storage, so that many faults
 * that are added one by one need no more time and memory than their number. Safe for use by several threads.
 *
 * @param <F> the type of the faults
 */
public final class FaultSequence<F> extends AbstractList<F> implements RandomAccess {

    /**
     * The faults of the sequences that share it. A place is written once, before a sequence that contains it exists,
     * for one of the sequences that end before it.
     */
    private static final class Storage {
        private Object[] faults;
        private int size;

        Storage(Object[] faults) {
            this.faults = faults;
            this.size = faults.length;
        }

        /** Returns an array with a fault at a place, after those before it; null if the place is taken. */
        synchronized Object[] add(int place, Object fault) {
            if (place != size) {
                return null;
            }
            if (size == faults.length) {
                faults = Arrays.copyOf(faults, Math.max(4, 2 * size));
            }
            faults[size++] = fault;
            return faults;
        }
    }

    private final Storage storage;
    /** The array of the storage when this sequence was made; a longer one may have replaced it. */
    private final Object[] faults;

    private final int from;
    private final int to;

    private FaultSequence(Storage storage, Object[] faults, int from, int to) {
        this.storage = storage;
        this.faults = faults;
        this.from = from;
        this.to = to;
    }

    private static <F> FaultSequence<F> ofArray(Object[] faults) {
        return new FaultSequence<>(new Storage(faults), faults, 0, faults.length);
    }

    /**
     * {@return no faults}
     *
     * @param <F> the type of the faults
     */
    public static <F> FaultSequence<F> empty() {
        return ofArray(new Object[0]);
    }

    /**
     * {@return the faults of a list; the list itself if it is a sequence}
     *
     * @param faults the faults, oldest first
     * @param <F> the type of the faults
     */
    public static <F> FaultSequence<F> copyOf(List<F> faults) {
        // A list of the JDK refuses null.
        return faults instanceof FaultSequence<F> sequence
                ? sequence
                : ofArray(List.copyOf(faults).toArray());
    }

    /**
     * {@return these faults and a newer one}
     *
     * @param fault the newer fault
     */
    public FaultSequence<F> with(F fault) {
        // Places of faults that were removed are left behind when they are more than the others. An empty sequence may
        // be a constant, so it shares nothing: it must not keep the faults that are added to it.
        Object[] shared = from < to && 2 * from <= to ? storage.add(to, fault) : null;
        if (shared != null) {
            return new FaultSequence<>(storage, shared, from, to + 1);
        }
        Storage own = new Storage(toArray());
        return new FaultSequence<>(own, own.add(size(), fault), 0, size() + 1);
    }

    /**
     * {@return these faults without the oldest that equals a fault; empty if there is none}
     *
     * @param fault the fault
     */
    public Optional<FaultSequence<F>> without(F fault) {
        int place = from;
        while (place < to && !fault.equals(faults[place])) {
            place++;
        }
        if (place == to) {
            return Optional.empty();
        }
        if (place == from) {
            return Optional.of(new FaultSequence<>(storage, faults, from + 1, to));
        }
        if (place == to - 1) {
            return Optional.of(new FaultSequence<>(storage, faults, from, to - 1));
        }
        Object[] others = new Object[size() - 1];
        System.arraycopy(faults, from, others, 0, place - from);
        System.arraycopy(faults, place + 1, others, place - from, to - place - 1);
        return Optional.of(ofArray(others));
    }

    @Override
    @SuppressWarnings("unchecked") // only faults of this type are stored
    public F get(int index) {
        return (F) faults[from + Objects.checkIndex(index, size())];
    }

    @Override
    public int size() {
        return to - from;
    }
}
