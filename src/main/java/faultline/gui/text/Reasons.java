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
public final class Reasons {

    private Reasons() {
    }

    /**
     * What an exception says.
     *
     * @param why the exception
     * @return a phrase without a stop, in the user's language as far as it is known there
     */
    public static String of(Throwable why) {
        if (why.getCause() != null && (why instanceof CompletionException || why instanceof UncheckedIOException)) {
            return of(why.getCause());
        }
        if (why instanceof ScenarioException bad) {
            return Wordings.text(bad.complaints().get(0).text());
        }
        if (why instanceof OutOfMemoryError) {
            return Texts.text("reason.memory");
        }
        if (why instanceof FileSystemException file) {
            return ofFile(file);
        }
        return Optional.ofNullable(why.getMessage()).filter(message -> !message.isBlank()).map(Wordings::text)
                .orElseGet(() -> Texts.text("reason.inside", why.getClass().getSimpleName()));
    }

    /**
     * What an exception says about a file whose name the user is told anyhow.
     *
     * @param why the exception
     * @param file that may be named before the reason
     * @return the phrase without the name
     */
    public static String of(Throwable why, Path file) {
        String named = file + ": ";
        boolean plain = !(why instanceof ScenarioException || why instanceof FileSystemException);
        return Optional.ofNullable(why.getMessage()).filter(text -> plain && text.startsWith(named)).map(text -> Wordings.text(text.substring(named.length())))
                .orElseGet(() -> of(why));
    }

    /** The system names the file, and often nothing else. */
    private static String ofFile(FileSystemException why) {
        if (why instanceof AccessDeniedException) {
            return Texts.text("reason.denied");
        }
        if (why instanceof NoSuchFileException) {
            return Texts.text("reason.noFile");
        }
        return Optional.ofNullable(why.getReason()).filter(reason -> !reason.isBlank()).orElseGet(() -> Texts.text("reason.disk"));
    }
}
