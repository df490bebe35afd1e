package faultline.gui.document;

import faultline.gui.document.RecoveryStore.RecoveredFile;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Looks for edits that a crash has left and offers them to the user. */
public final class RecoveryPrompt {

    private static final Logger LOG = Logger.getLogger(RecoveryPrompt.class.getName());

    /** What becomes of edits after an offer. */
    public enum Answer {
        /** The edits are open. */
        RECOVER,
        /** The edits are discarded. */
        DISCARD,
        /** The edits are offered again at the next start: the question was closed, or they could not be opened. */
        LATER
    }

    private RecoveryPrompt() {}

    /**
     * Offers the edits of a crashed process, asynchronously, or calls {@code otherwise} if there are none. Both
     * callbacks run on the event dispatch thread, where {@code offer} calls its consumer with the answer. Recovered
     * edits are kept as those of this process, which {@code autosave} then deletes when they are saved.
     */
    public static void offerRecovery(
            RecoveryStore recovery,
            Autosave autosave,
            BiConsumer<RecoveredFile, Consumer<Answer>> offer,
            Runnable otherwise) {
        BackgroundTasks.compute(
                recovery::findOrphan,
                found -> found.ifPresentOrElse(
                        file -> offer.accept(file, answer -> answered(recovery, autosave, file, answer)), otherwise),
                failure -> {
                    logFailure(failure);
                    otherwise.run();
                });
    }

    private static void answered(RecoveryStore recovery, Autosave autosave, RecoveredFile file, Answer answer) {
        BackgroundTasks.perform(
                () -> {
                    switch (answer) {
                        case RECOVER -> recovery.adopt(file);
                        case DISCARD -> recovery.discard(file);
                        default -> recovery.release();
                    }
                },
                () -> {
                    if (answer == Answer.RECOVER) {
                        autosave.editsAdopted(file.scenario());
                    }
                },
                RecoveryPrompt::logFailure);
    }

    private static void logFailure(Throwable failure) {
        LOG.log(Level.WARNING, "the edits of a crashed process cannot be read or deleted", failure);
    }
}
