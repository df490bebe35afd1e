package faultline.gui.document;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Function;
import java.util.logging.Level;
import java.util.logging.Logger;

/** Looks for what a crash has left, and offers it. */
public final class RecoveryPrompt {

    private static final Logger LOG = Logger.getLogger(RecoveryPrompt.class.getName());

    /** What is to become of edits that a crash has left. */
    public enum Answer {
        /** They are open again. */
        RECOVER,
        /** They are given up. */
        DISCARD,
        /** They are offered again at the next start. */
        LATER
    }

    private RecoveryPrompt() {}

    /**
     * Looks, soon. What is offered is taken away afterwards, unless the user puts it off: if it was taken, the window
     * that has it keeps it under its own number.
     *
     * @param recovery where to look
     * @param offer asks the user, on the event dispatch thread
     * @param otherwise done on the event dispatch thread where nothing was left
     */
    public static void offerRecovery(
            RecoveryStore recovery, Function<RecoveryStore.RecoveredFile, Answer> offer, Runnable otherwise) {
        BackgroundTasks.run(
                recovery::findOrphan,
                left -> left.ifPresentOrElse(rescue -> offer(recovery, rescue, offer), otherwise),
                why -> {
                    logFailure(why);
                    otherwise.run();
                });
    }

    private static void offer(
            RecoveryStore recovery,
            RecoveryStore.RecoveredFile rescue,
            Function<RecoveryStore.RecoveredFile, Answer> offer) {
        Answer answer = offer.apply(rescue);
        if (answer != Answer.LATER) {
            BackgroundTasks.run(
                    () -> resolve(recovery, rescue, answer == Answer.RECOVER), done -> {}, RecoveryPrompt::logFailure);
        }
    }

    private static Optional<RecoveryStore.RecoveredFile> resolve(
            RecoveryStore recovery, RecoveryStore.RecoveredFile rescue, boolean taken) throws IOException {
        if (taken) {
            recovery.adopt(rescue);
        } else {
            recovery.delete(rescue.recoveryFile());
        }
        return Optional.of(rescue);
    }

    private static void logFailure(Throwable why) {
        LOG.log(Level.WARNING, "what a crash has left cannot be read", why);
    }
}
