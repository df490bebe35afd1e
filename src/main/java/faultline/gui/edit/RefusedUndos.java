package faultline.gui.edit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * The edits whose undo the run has refused. They are passed over, so that earlier edits of other things can be undone.
 * When all of them have been tried, they are tried again in turn.
 */
final class RefusedUndos {

    /** The edits that were refused in this turn. */
    private final Set<Edit> refused = new HashSet<>();

    /** The indices of edits before they were undone, because one whose undo is refused stays where it is. */
    private final Map<Edit, Integer> places = new HashMap<>();

    /** Forgets all edits, because others may be undone now, and places may be others. */
    void clear() {
        refused.clear();
        places.clear();
    }

    /** Records that an edit is being undone, and its index. */
    void undone(Edit edit, int place) {
        places.put(edit, place);
    }

    /** Records that an edit is done again. */
    void redone(Edit edit) {
        refused.remove(edit);
        places.remove(edit);
    }

    /** Records that the undo of an edit was refused. A second refusal begins a new turn. */
    void add(Edit edit) {
        if (!refused.add(edit)) {
            refused.retainAll(Set.of(edit));
        }
    }

    /** Returns the index of an edit before it was undone, at most that which it has now. */
    int placeOf(Edit edit, int now) {
        return Math.min(now, places.getOrDefault(edit, now));
    }

    /**
     * Returns the edit that is undone next: the last one that is effective, or before those that were refused, the last
     * one that changes other things than all effective ones after it.
     */
    Optional<Edit> next(List<Edit> done, Predicate<Edit> isEffective) {
        List<Edit> passed = new ArrayList<>();
        for (int index = done.size() - 1; index >= 0; index--) {
            Edit edit = done.get(index);
            if (isEffective.test(edit)) {
                if (!refused.contains(edit) && isIndependent(edit, passed)) {
                    return Optional.of(edit);
                }
                passed.add(edit);
            }
        }
        return passed.stream().findFirst();
    }

    private static boolean isIndependent(Edit edit, List<Edit> later) {
        return later.isEmpty()
                || edit instanceof CommandEdit command
                        && later.stream()
                                .allMatch(
                                        other -> other instanceof CommandEdit newer && command.isIndependentOf(newer));
    }
}
