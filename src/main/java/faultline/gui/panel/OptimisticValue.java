package faultline.gui.panel;

/**
 * Bridges the moment between a command and the first snapshot that shows what it did, so that a control does not jump
 * back and forth. What does not come back within that moment was refused, and the control shows what is true.
 *
 * @param <T> what the control sets
 */
final class OptimisticValue<T> {

    /** How many snapshots a command may take; at sixty in a second, half a second. */
    static final int TIMEOUT_SNAPSHOTS = 30;

    private T value;
    private int snapshotsLeft;

    /** Begins with what is true now. */
    OptimisticValue(T told) {
        this.value = told;
    }

    /** What the user last asked for, or what is true where that was long ago. */
    T value() {
        return value;
    }

    /** Takes note of what the user asks for. */
    T request(T wanted) {
        value = wanted;
        snapshotsLeft = TIMEOUT_SNAPSHOTS;
        return wanted;
    }

    /** Takes note of what is true; says what is to show. */
    T update(T truth) {
        if (snapshotsLeft > 0 && !truth.equals(value)) {
            snapshotsLeft--;
        } else {
            snapshotsLeft = 0;
            value = truth;
        }
        return value;
    }
}
