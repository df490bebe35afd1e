package faultline.gui.document;

import faultline.gui.document.RecoveryStore.RecoveredFile;
import java.util.function.Function;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Looks for edits that a crash has left and offers them to the user. */
public final class RecoveryPrompt {

    private static final Logger LOG = Logger.getLogger(RecoveryPrompt.class.getName());

    /** The user's answer to an offer. */
    public enum Answer {
        /** The edits are opened. */
        RECOVER,
        /** The edits are discarded. */
        DISCARD,
        /** The edits are offered again at the next start. */
        LATER
    }

    private RecoveryPrompt() {}

    /**
     * Offers the edits of a crashed process, asynchronously, or calls {@code otherwise} if there are none. Both
     * callbacks run on the event dispatch thread. Recovered edits are kept as those of this process, which
     * {@code autosave} then deletes when they are saved.
     */
    public static void offerRecovery(
            RecoveryStore recovery, Autosave autosave, Function<RecoveredFile, Answer> offer, Runnable otherwise) {
        BackgroundTasks.run(
                recovery::findOrphan,
                found -> found.ifPresentOrElse(file -> offer(recovery, autosave, file, offer), otherwise),
                failure -> {
                    logFailure(failure);
                    otherwise.run();
                });
    }

    private static void offer(
            RecoveryStore recovery, Autosave autosave, RecoveredFile file, Function<RecoveredFile, Answer> offer) {
        Answer answer = offer.apply(file);
        BackgroundTasks.run(
                () -> {
                    switch (answer) {
                        case RECOVER -> recovery.adopt(file);
                        case DISCARD -> recovery.discard(file);
                        default -> recovery.release();
                    }
                    return answer;
                },
                done -> {
                    if (done == Answer.RECOVER) {
                        autosave.editsAdopted(file.scenario());
                    }
                },
                RecoveryPrompt::logFailure);
    }

    private static void logFailure(Throwable failure) {
        LOG.log(Level.WARNING, "the edits of a crashed process cannot be read or deleted", failure);
    }
}
