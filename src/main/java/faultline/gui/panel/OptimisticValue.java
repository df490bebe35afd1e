package faultline.gui.panel;

/**
 * Shows a requested value until a snapshot confirms it, so that a control does not jump back and forth. A value that is
 * not confirmed in time was refused, and the control shows the actual value.
 *
 * @param <T> the type of the value
 */
final class OptimisticValue<T> {

    /** Number of snapshots until a request expires; half a second at sixty snapshots per second. */
    static final int TIMEOUT_SNAPSHOTS = 30;

    private T value;
    private int snapshotsLeft;

    /** Creates a value with the actual value. */
    OptimisticValue(T actual) {
        this.value = actual;
    }

    /** Returns the requested value, or the actual one if the request has expired. */
    T value() {
        return value;
    }

    /** Stores a requested value and returns it. */
    T request(T requested) {
        value = requested;
        snapshotsLeft = TIMEOUT_SNAPSHOTS;
        return requested;
    }

    /** Updates the actual value and returns the value to show. */
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
