package faultline.engine;

import faultline.io.MessageText;
import java.util.Arrays;
import java.util.Optional;

/** Exceptions of controllers as text. */
final class ExceptionText {

    /** The greatest length of an exception, and of its place, as of a line of a child's standard error. */
    private static final int MAX_LENGTH = 400;

    private ExceptionText() {}

    /**
     * Returns an exception of a controller as text, which its own methods may fail to give, and the line that threw it,
     * if there is one outside of the JDK and this program.
     */
    static String of(Throwable exception) {
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
