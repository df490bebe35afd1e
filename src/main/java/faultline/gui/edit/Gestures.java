package faultline.gui.edit;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * Numbers the gestures of the user. All commands of a gesture form one edit: those of a drag, and repeated commands
 * about the same targets, such as the steps of a spinner.
 */
final class Gestures {

    /** The longest pause between repeated commands about the same targets that form one edit, milliseconds. */
    private static final long REPEAT_MILLIS = 1000;

    private final LongSupplier clock;
    private int id;
    private boolean active;
    private List<EditTarget> lastTargets = List.of();
    private long lastMillis;

    /** Creates gestures without any, given a clock that returns milliseconds. */
    Gestures(LongSupplier clock) {
        this.clock = clock;
    }

    /**
     * Returns the id of a new gesture, unless one is active or the targets repeat the last ones. Changes of the setup
     * and events come from keys that are pressed during a drag, so they are not part of the active one.
     */
    int idOf(List<EditTarget> targets) {
        long now = clock.getAsLong();
        boolean repeated = targets.equals(lastTargets)
                && now - lastMillis <= REPEAT_MILLIS
                && targets.stream().allMatch(EditTarget::repeatable);
        boolean ofKey = areAllOf(EditTarget.SETUP, targets) || areAllOf(EditTarget.EVENT, targets);
        if (!repeated && (!active || ofKey)) {
            id++;
        }
        lastTargets = targets;
        lastMillis = now;
        return id;
    }

    /** Starts a gesture: all commands until it ends have its id. */
    void begin() {
        interrupt();
        active = true;
    }

    void end() {
        interrupt();
        active = false;
    }

    /** Gives later commands another id, also if they repeat the last ones. */
    void interrupt() {
        id++;
        lastTargets = List.of();
    }

    /** Returns whether all targets of the last commands are of a kind; true if there are none. */
    boolean areLastOf(String kind) {
        return areAllOf(kind, lastTargets);
    }

    private static boolean areAllOf(String kind, List<EditTarget> targets) {
        return targets.stream().allMatch(target -> target.kind().equals(kind));
    }
}
