package faultline.gui.text;

import faultline.scenario.ScenarioException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletionException;

/** Why something could not be done, as a phrase for people and never a trace. */
public final class ErrorMessages {

    private ErrorMessages() {}

    /**
     * What an exception says.
     *
     * @param why the exception
     * @return a phrase without a stop, in the user's language as far as it is known there
     */
    public static String describe(Throwable why) {
        if (why.getCause() != null && (why instanceof CompletionException || why instanceof UncheckedIOException)) {
            return describe(why.getCause());
        }
        if (why instanceof ScenarioException bad) {
            return MessageTranslator.translate(bad.problems().get(0).message());
        }
        if (why instanceof OutOfMemoryError) {
            return Messages.get("reason.memory");
        }
        if (why instanceof FileSystemException file) {
            return describeFileError(file);
        }
        return Optional.ofNullable(why.getMessage())
                .filter(message -> !message.isBlank())
                .map(MessageTranslator::translate)
                .orElseGet(() -> Messages.get("reason.inside", why.getClass().getSimpleName()));
    }

    /**
     * What an exception says about a file whose name the user is told anyhow.
     *
     * @param why the exception
     * @param file that may be named before the reason
     * @return the phrase without the name
     */
    public static String describe(Throwable why, Path file) {
        String named = file + ": ";
        boolean plain = !(why instanceof ScenarioException || why instanceof FileSystemException);
        return Optional.ofNullable(why.getMessage())
                .filter(text -> plain && text.startsWith(named))
                .map(text -> MessageTranslator.translate(text.substring(named.length())))
                .orElseGet(() -> describe(why));
    }

    /** The system names the file, and often nothing else. */
    private static String describeFileError(FileSystemException why) {
        if (why instanceof AccessDeniedException) {
            return Messages.get("reason.denied");
        }
        if (why instanceof NoSuchFileException) {
            return Messages.get("reason.noFile");
        }
        return Optional.ofNullable(why.getReason())
                .filter(reason -> !reason.isBlank())
                .orElseGet(() -> Messages.get("reason.disk"));
    }
}
