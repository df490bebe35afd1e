package faultline.gui.document;

import faultline.gui.document.RecoveryStore.RecoveredFile;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * Looks for edits that crashes have left and offers them to the user, one after another until some are opened. Event
 * dispatch thread only.
 */
public final class RecoveryPrompt {

    private static final Logger LOG = Logger.getLogger(RecoveryPrompt.class.getName());

    /** What becomes of edits after an offer. */
    public enum Answer {
        /** The edits are open. All others are offered at the next start. */
        RECOVER,
        /** The edits are discarded. */
        DISCARD,
        /** The edits are offered again at the next start: the user has chosen so, or closed the question. */
        LATER,
        /** The edits could not be opened. They and all others are offered at the next start. */
        NOT_OPENED
    }

    private final RecoveryStore recovery;
    private final Autosave autosave;
    private final BiConsumer<RecoveredFile, Consumer<Answer>> question;
    private final Consumer<List<RecoveredFile>> onOthers;
    private final Set<Path> offered = new HashSet<>();

    private RecoveryPrompt(
            RecoveryStore recovery,
            Autosave autosave,
            BiConsumer<RecoveredFile, Consumer<Answer>> question,
            Consumer<List<RecoveredFile>> onOthers) {
        this.recovery = recovery;
        this.autosave = autosave;
        this.question = question;
        this.onOthers = onOthers;
    }

    /**
     * Offers the edits of crashed processes, asynchronously, or calls {@code otherwise} if there are none. The
     * callbacks run on the event dispatch thread, where {@code question} calls its consumer with the answer. Recovered
     * edits are kept as those of this process, which {@code autosave} then deletes when they are saved;
     * {@code onOthers} receives those that are left for the next start, if there are any.
     */
    public static void offerRecovery(
            RecoveryStore recovery,
            Autosave autosave,
            BiConsumer<RecoveredFile, Consumer<Answer>> question,
            Consumer<List<RecoveredFile>> onOthers,
            Runnable otherwise) {
        new RecoveryPrompt(recovery, autosave, question, onOthers).offerNext(otherwise);
    }

    private void offerNext(Runnable otherwise) {
        Set<Path> before = Set.copyOf(offered);
        BackgroundTasks.compute(
                () -> recovery.findOrphan(before), found -> found.ifPresentOrElse(this::offer, otherwise), failure -> {
                    logFailure(failure);
                    otherwise.run();
                });
    }

    private void offer(RecoveredFile file) {
        offered.add(file.recoveryFile());
        question.accept(file, answer -> answered(file, answer));
    }

    private void answered(RecoveredFile file, Answer answer) {
        BackgroundTasks.perform(
                () -> {
                    switch (answer) {
                        case RECOVER -> recovery.adopt(file);
                        case DISCARD -> recovery.discard(file);
                        default -> recovery.release();
                    }
                },
                () -> {
                    switch (answer) {
                        case RECOVER -> {
                            autosave.editsAdopted(file.scenario());
                            reportOthers();
                        }
                        case DISCARD, LATER -> offerNext(() -> {});
                        default -> {}
                    }
                },
                RecoveryPrompt::logFailure);
    }

    /** Reports the edits that are left. The window has room for those of one scenario. */
    private void reportOthers() {
        BackgroundTasks.compute(
                recovery::orphanedEdits,
                others -> {
                    if (!others.isEmpty()) {
                        onOthers.accept(others);
                    }
                },
                RecoveryPrompt::logFailure);
    }

    private static void logFailure(Throwable failure) {
        LOG.log(Level.WARNING, "the edits of a crashed process cannot be read or deleted", failure);
    }
}
