package faultline.gui.text;

import faultline.engine.RunFailedException;
import faultline.io.Message;
import faultline.io.MessageException;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.ScenarioException;
import java.awt.print.PrinterException;
import java.awt.print.PrinterIOException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Describes exceptions to users. */
public final class ErrorMessages {

    /**
     * The JDK's messages about a program that does not exist, such as the one that sends pages to a printer: "error=2,"
     * up to version 24, and then "error: 2 (".
     */
    private static final Pattern NOT_STARTED = Pattern.compile("^Cannot run program \"([^\"]+)\".*error(?:=|: )2\\b");

    private ErrorMessages() {}

    /** Describes an exception by a phrase without a full stop, in the user's language if the message is known. */
    public static String describe(Throwable exception) {
        if (exception.getCause() != null
                && (exception instanceof CompletionException
                        || exception instanceof UncheckedIOException
                        || exception instanceof PrinterIOException)) {
            return describe(exception.getCause());
        }
        if (exception instanceof ScenarioException bad) {
            return Messages.get(bad.problems().get(0).message());
        }
        if (exception instanceof RunFailedException failed) {
            return Messages.get(failed.reason());
        }
        if (exception instanceof MessageException file) {
            return (file.subject().isEmpty() ? "" : file.subject() + ": ") + Messages.get(innerReason(file.reason()));
        }
        if (exception instanceof OutOfMemoryError) {
            return Messages.get("reason.memory");
        }
        if (exception instanceof FileSystemException file) {
            return describeFileError(file);
        }
        return describeMessage(exception);
    }

    /** Describes an exception by its message. */
    private static String describeMessage(Throwable exception) {
        String message = Objects.requireNonNullElse(exception.getMessage(), "");
        Matcher program = NOT_STARTED.matcher(message);
        if (exception instanceof IOException && program.find()) {
            return Messages.get("reason.program", program.group(1));
        }
        if (!message.isBlank()) {
            return message;
        }
        return exception instanceof PrinterException
                ? Messages.get("reason.printer")
                : Messages.get("reason.inside", exception.getClass().getSimpleName());
    }

    /** Returns the reason why a scenario cannot be saved, because what shows it says that it cannot be saved. */
    private static Message innerReason(Message reason) {
        return reason.template() == ProblemKind.NOT_SAVED && reason.arguments().get(0) instanceof Message inner
                ? inner
                : reason;
    }

    /** Describes an exception about a file without its name, which the user already knows. */
    public static String describe(Throwable exception, Path file) {
        String prefix = file + ": ";
        String text = describe(exception);
        return text.startsWith(prefix) ? text.substring(prefix.length()) : text;
    }

    /**
     * Describes an exception about a file without its name by a phrase with a capital letter, unless that begins with
     * the name of another file.
     */
    public static String describeAsSentence(Throwable exception, Path file) {
        String text = describe(exception, file);
        boolean named = exception instanceof MessageException problem
                && !problem.subject().isEmpty()
                && text.startsWith(problem.subject());
        return named ? text : capitalised(text);
    }

    /** Returns a phrase with a capital letter. */
    public static String capitalised(String phrase) {
        return phrase.isEmpty() ? "" : phrase.substring(0, 1).toUpperCase(Locale.ROOT) + phrase.substring(1);
    }

    /** Describes a file system error, whose message is often only the file's name. */
    private static String describeFileError(FileSystemException exception) {
        if (exception instanceof AccessDeniedException) {
            return Messages.get("reason.denied");
        }
        if (exception instanceof NoSuchFileException) {
            return Messages.get("reason.noFile");
        }
        return Optional.ofNullable(exception.getReason())
                .filter(reason -> !reason.isBlank())
                .orElseGet(() -> Messages.get("reason.disk"));
    }
}
