package faultline.sensor;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;

/**
 * Active faults, each with an entry, such as the index of the command that began it. Of equal faults, the oldest ends
 * first. Not safe for use by several threads.
 *
 * @param <F> the type of the faults
 * @param <E> the type of the entries
 */
public final class OldestFirst<F, E> {

    /** The entries of the active faults, of equal ones the oldest first. */
    private Map<F, Queue<E>> entries = new HashMap<>();

    /** Creates an object without faults. */
    public OldestFirst() {}

    /**
     * Begins a fault.
     *
     * @param fault the fault
     * @param entry its entry
     */
    public void begin(F fault, E entry) {
        entries.computeIfAbsent(fault, begun -> new ArrayDeque<>(1)).add(entry);
    }

    /**
     * Ends the oldest of the active faults that equal a fault.
     *
     * @param fault the fault
     * @return the entry of the fault that ends; empty if none does
     */
    public Optional<E> end(F fault) {
        Queue<E> equal = entries.get(fault);
        if (equal == null) {
            return Optional.empty();
        }
        E oldest = equal.remove();
        if (equal.isEmpty()) {
            entries.remove(fault);
        }
        return Optional.of(oldest);
    }

    /**
     * Ends all active faults.
     *
     * @return their entries, in no particular order
     */
    public List<E> endAll() {
        List<E> all = entries.values().stream().flatMap(Collection::stream).toList();
        // A map that is cleared keeps its capacity, so each later call would take as long as this one.
        entries = new HashMap<>();
        return all;
    }
}
