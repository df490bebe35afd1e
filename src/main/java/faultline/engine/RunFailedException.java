package faultline.engine;

import faultline.control.RecordEndedException;
import faultline.io.Message;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.function.Supplier;

/**
 * Thrown if a run cannot start or continue, or its result cannot be computed: its controller cannot be found, created
 * or closed, threw an exception or does not answer; the contacts of the robot cannot be found; the run was interrupted;
 * or an error of the program itself ended it. The message is one sentence for the user.
 */
public class RunFailedException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    /** The reasons whose cause is an exception of a controller, or of what loads, creates or closes it. */
    private static final Set<RunProblem> OF_CONTROLLER = Set.of(
            RunProblem.CONTROLLER_BROKE,
            RunProblem.NOT_CREATED,
            RunProblem.NOT_CLOSED,
            RunProblem.NOT_LOADED,
            RunProblem.NAMELESS);

    private final transient Message reason;

    /**
     * Creates an exception.
     *
     * @param message one sentence for the user
     * @param cause the cause, or null
     */
    public RunFailedException(String message, Throwable cause) {
        this(RunProblem.OTHER.with(message), cause);
    }

    /**
     * Creates an exception whose message can be translated.
     *
     * @param reason one sentence for the user
     * @param cause the cause, or null
     */
    public RunFailedException(Message reason, Throwable cause) {
        super(reason.toString(), cause);
        this.reason = reason;
    }

    /** {@return one sentence for the user} */
    public final Message reason() {
        return reason;
    }

    /** {@return whether an exception of a controller, or of what loads, creates or closes it, is the cause} */
    public final boolean isOfController() {
        return reason.template() instanceof RunProblem problem && OF_CONTROLLER.contains(problem);
    }

    /**
     * {@return the exception for a run whose controller threw another one; the same if it is of this type}
     *
     * @param tick the tick of the observation
     * @param cause the exception of the controller
     */
    public static RunFailedException ofController(long tick, Throwable cause) {
        return ofController(tick, cause, () -> ExceptionText.of(cause));
    }

    /** Returns the exception for a run whose controller threw another one, given what describes that one. */
    static RunFailedException ofController(long tick, Throwable cause, Supplier<String> description) {
        if (cause instanceof RunFailedException failed) {
            return failed;
        }
        return new RunFailedException(
                cause instanceof RecordEndedException ended
                        ? RunProblem.RECORD_ENDED.with(ended.ticks())
                        : RunProblem.CONTROLLER_BROKE.with(tick, description.get()),
                cause);
    }

    /**
     * Returns the exception that a call on the thread of a controller has thrown, or one with a reason that takes a
     * description if it is of another type.
     */
    static RunFailedException ofCall(ExecutionException broken, RunProblem otherwise) {
        return broken.getCause() instanceof RunFailedException failed
                ? failed
                : new RunFailedException(otherwise.with(broken.getMessage()), broken.getCause());
    }
}
