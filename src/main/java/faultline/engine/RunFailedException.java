package faultline.engine;

import faultline.control.RecordEndedException;
import faultline.io.Message;
import faultline.io.MessageText;
import java.util.Arrays;
import java.util.Optional;
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

    /** The greatest length of an exception of a controller as text, as of a line of a child's standard error. */
    private static final int MAX_LENGTH = 400;

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
        return ofController(tick, cause, () -> describe(cause));
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

    /**
     * Returns an exception of a controller as text, which its own methods may fail to give, and the line that threw it,
     * if there is one outside of the JDK and this program.
     */
    static String describe(Throwable exception) {
        try {
            Throwable reason = reason(exception);
            String start = MessageText.shortened(reason.toString(), MAX_LENGTH);
            return place(reason.getStackTrace(), Thread.currentThread().getStackTrace())
                    .map(place -> start + " at " + MessageText.start(place.toString(), MAX_LENGTH))
                    .orElse(start);
        } catch (RuntimeException | Error e) {
            return exception.getClass().getName() + ", whose text cannot be read";
        }
    }

    /**
     * Returns an exception, or its cause if it says nothing else. If the initialisation of a class has failed, later
     * uses of the class throw an error whose cause has the text and the place of the first one.
     */
    private static Throwable reason(Throwable exception) {
        Throwable cause = exception.getCause();
        boolean saysNothingElse = exception.getMessage() == null || cause instanceof ExceptionInInitializerError;
        return cause != null && saysNothingElse ? cause : exception;
    }

    /**
     * Returns the innermost frame of neither the JDK nor this program. The frames that the caller of the controller is
     * in itself, such as those of a test, are not the controller's.
     */
    private static Optional<StackTraceElement> place(StackTraceElement[] thrown, StackTraceElement[] caller) {
        int own = thrown.length;
        for (int i = caller.length; own > 0 && i > 0 && thrown[own - 1].equals(caller[i - 1]); i--) {
            own--;
        }
        return Arrays.stream(thrown, 0, own)
                .filter(frame -> !isOfJdk(frame) && !frame.getClassName().startsWith("faultline."))
                .findFirst();
    }

    private static boolean isOfJdk(StackTraceElement frame) {
        String module = frame.getModuleName();
        return module != null && (module.startsWith("java.") || module.startsWith("jdk."));
    }
}
