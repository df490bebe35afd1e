package faultline.gui.document;

import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;

/** Something slow on its way to the bench: how far it has come, and whether it is still wanted. For any thread. */
public final class TaskProgress {

    private static final double UNKNOWN = -1;

    private final TaskKind task;
    private final Path name;
    private volatile double fraction = UNKNOWN;
    private volatile boolean cancelled;

    TaskProgress(TaskKind task, Path name) {
        this.task = task;
        this.name = name;
    }

    /**
     * What is done.
     *
     * @return the task
     */
    public TaskKind task() {
        return task;
    }

    /**
     * With what it is done.
     *
     * @return a file, or the name of a scenario without one
     */
    public Path name() {
        return name;
    }

    /**
     * How far it has come.
     *
     * @return in [0, 1], empty where nobody knows
     */
    public OptionalDouble fraction() {
        return fraction == UNKNOWN ? OptionalDouble.empty() : OptionalDouble.of(fraction);
    }

    void setFraction(double newShare) {
        fraction = newShare;
    }

    void cancel() {
        cancelled = true;
    }

    boolean isActive() {
        return !cancelled;
    }

    void throwIfCancelled() {
        if (cancelled) {
            throw new CancellationException("no longer wanted");
        }
    }
}
