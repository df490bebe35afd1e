package faultline.sensor;

import java.lang.ref.SoftReference;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.RandomAccess;

/**
 * Active faults, oldest first: an immutable list whose copy with one fault more or fewer shares its storage, so that
 * many faults that are added and removed one by one need no more time and memory than their number. Safe for use by
 * several threads.
 *
 * @param <F> the type of the faults
 */
public final class FaultSequence<F> extends AbstractList<F> implements RandomAccess {

    /**
     * The history of the sequences that share it: the faults in the order in which they were added, and the places of
     * those that were removed, in the order of their removal. Only the newest sequence is continued, so a sequence
     * holds what its first {@code end} additions less its first {@code removals} removals leave. What a sequence uses
     * is written before it exists and never changes.
     */
    private static final class Storage {
        private Object[] faults;
        private int end;
        private int[] removed = new int[0];
        private int removals;
        /** The number of removals that took the oldest fault, from the first place on. */
        private int leading;
        /** The places of the faults that are left; null until a fault is to be removed. */
        private OldestFirst<Object, Integer> places;

        Storage(Object[] faults) {
            this.faults = faults;
            this.end = faults.length;
        }

        void add(Object fault) {
            if (end == faults.length) {
                faults = Arrays.copyOf(faults, Math.max(4, 2 * end));
            }
            faults[end] = fault;
            if (places != null) {
                places.begin(fault, end);
            }
            end++;
        }

        /** Removes the oldest of equal faults, and returns whether there is one. */
        boolean remove(Object fault) {
            if (places == null) {
                places = new OldestFirst<>();
                for (int place = 0; place < end; place++) {
                    places.begin(faults[place], place);
                }
            }
            Optional<Integer> oldest = places.end(fault);
            oldest.ifPresent(this::removeAt);
            return oldest.isPresent();
        }

        private void removeAt(int place) {
            if (removals == removed.length) {
                removed = Arrays.copyOf(removed, Math.max(4, 2 * removals));
            }
            removed[removals++] = place;
            leading += place == leading ? 1 : 0;
        }
    }

    private final Storage storage;
    /** The arrays of the storage when this sequence was made; longer ones may have replaced them. */
    private final Object[] faults;

    private final int[] removed;
    private final int end;
    private final int removals;
    private final int leading;
    /** The faults that are left; made when they are read, and again after memory was short. */
    private volatile SoftReference<Object[]> left;

    /** Creates the newest sequence of a storage, whose lock is held if others share it. */
    private FaultSequence(Storage storage) {
        this.storage = storage;
        this.faults = storage.faults;
        this.removed = storage.removed;
        this.end = storage.end;
        this.removals = storage.removals;
        this.leading = storage.leading;
    }

    /**
     * {@return no faults}
     *
     * @param <F> the type of the faults
     */
    public static <F> FaultSequence<F> empty() {
        return new FaultSequence<>(new Storage(new Object[0]));
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
                : new FaultSequence<>(new Storage(List.copyOf(faults).toArray()));
    }

    /**
     * {@return these faults and a newer one}
     *
     * @param fault the newer fault
     */
    public FaultSequence<F> with(F fault) {
        // Faults that were removed are left behind when they are more than the others. An empty sequence may be a
        // constant, so it shares nothing: it must not keep the faults that are added to it.
        if (!isEmpty() && 2 * removals <= end) {
            synchronized (storage) {
                if (isNewest()) {
                    storage.add(fault);
                    return new FaultSequence<>(storage);
                }
            }
        }
        Storage own = new Storage(toArray());
        own.add(fault);
        return new FaultSequence<>(own);
    }

    /**
     * {@return these faults without the oldest that equals a fault; empty if there is none}
     *
     * @param fault the fault
     */
    public Optional<FaultSequence<F>> without(F fault) {
        synchronized (storage) {
            if (isNewest()) {
                return remove(storage, fault);
            }
        }
        return remove(new Storage(toArray()), fault);
    }

    private static <F> Optional<FaultSequence<F>> remove(Storage storage, F fault) {
        return storage.remove(fault) ? Optional.of(new FaultSequence<>(storage)) : Optional.empty();
    }

    private boolean isNewest() {
        return end == storage.end && removals == storage.removals;
    }

    @Override
    @SuppressWarnings("unchecked") // only faults of this type are stored
    public F get(int index) {
        Objects.checkIndex(index, size());
        return (F) (leading == removals ? faults[leading + index] : left()[index]);
    }

    private Object[] left() {
        SoftReference<Object[]> known = left;
        Object[] array = known == null ? null : known.get();
        if (array == null) {
            array = findLeft();
            left = new SoftReference<>(array);
        }
        return array;
    }

    private Object[] findLeft() {
        BitSet gone = new BitSet(end);
        for (int i = 0; i < removals; i++) {
            gone.set(removed[i]);
        }
        Object[] array = new Object[size()];
        int place = -1;
        for (int i = 0; i < array.length; i++) {
            place = gone.nextClearBit(place + 1);
            array[i] = faults[place];
        }
        return array;
    }

    @Override
    public int size() {
        return end - removals;
    }
}
