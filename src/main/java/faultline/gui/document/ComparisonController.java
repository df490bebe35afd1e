package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.recording.HashTrace;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/**
 * Keeps an earlier run beside the one on the bench, and finds where the two first differ. Another scenario on the bench
 * drives it out.
 */
public final class ComparisonController {

    private final Workspace workspace;
    private final RunNavigator navigator;
    private Optional<RunComparison> comparison = Optional.empty();
    private HashTrace comparedHashes = HashTrace.EMPTY;
    private Optional<TaskProgress> pendingTask = Optional.empty();

    /**
     * For a bench.
     *
     * @param bench whose run is compared
     * @param travel knows how far the run has been
     */
    public ComparisonController(Workspace bench, RunNavigator travel) {
        this.workspace = bench;
        this.navigator = travel;
        bench.addSessionListener((task, made) -> {
            if (task == TaskKind.OPEN) {
                removeReference();
            }
        });
    }

    /** Makes the run as far as it has been the ghost, soon. */
    public void captureCurrentRun() {
        workspace.openDocument().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().fullJournal();
            ScenarioDocument document = now.document();
            startReference(
                    document.displayPath(),
                    way -> runReference(document.initial().name(), journal.join(), way));
        });
    }

    /**
     * Runs a scenario, a saved journal for one, and makes that run the ghost, soon.
     *
     * @param file the scenario file
     */
    public void loadReference(Path file) {
        startReference(file, way -> {
            Scenario scenario = Scenario.load(file);
            return runReference(
                    scenario.name(),
                    new Journal(scenario.setup(), List.of(), scenario.setup().ticks()),
                    way);
        });
    }

    private static NamedReferenceRun runReference(String name, Journal journal, TaskProgress way) {
        return new NamedReferenceRun(
                name,
                journal.setup().seed(),
                journal.setup().dt(),
                ReferenceRun.replay(journal, tick -> way.isActive()));
    }

    /** Runs something in the place of whatever is being run. */
    private void startReference(Path name, ProgressCallable<NamedReferenceRun> maker) {
        cancelPendingTask();
        TaskProgress way = new TaskProgress(TaskKind.GHOST, name);
        pendingTask = Optional.of(way);
        BackgroundTasks.run(
                () -> maker.call(way),
                made -> completeTask(way, () -> setReference(made)),
                why -> completeTask(way, () -> workspace.listener().taskFailed(TaskKind.GHOST, name, why)));
    }

    private void completeTask(TaskProgress way, Runnable outcome) {
        if (way.isActive()) {
            pendingTask = Optional.empty();
            outcome.run();
        }
    }

    private void cancelPendingTask() {
        pendingTask.ifPresent(TaskProgress::cancel);
        pendingTask = Optional.empty();
    }

    private void setReference(NamedReferenceRun ghost) {
        workspace.scenario().ifPresent(scenario -> {
            comparedHashes = HashTrace.EMPTY;
            comparison = Optional.of(new RunComparison(
                    ghost,
                    OptionalLong.empty(),
                    ghost.seed() != scenario.setup().seed()));
        });
    }

    /** Shows no earlier run any more, and gives up the one that is being run. */
    public void removeReference() {
        cancelPendingTask();
        comparison = Optional.empty();
    }

    /**
     * Whether an earlier run is being run again, to be shown soon.
     *
     * @return true until it is there, or has failed or been removed
     */
    public boolean isLoading() {
        return pendingTask.isPresent();
    }

    /**
     * Compares what has been run since the last look.
     *
     * @param frame the newest
     * @return the earlier run and how the two differ so far, empty where none is kept; the same object as before where
     *     nothing is new
     */
    public Optional<RunComparison> update(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        HashTrace now = frame.recording().hashTrace();
        int from = now.isContinuationOf(comparedHashes) ? comparedHashes.size() : 0;
        comparison = comparison.map(last -> compare(last, now, from));
        comparedHashes = now;
        return comparison;
    }

    private RunComparison compare(RunComparison last, HashTrace now, int from) {
        if (last.divergence().isPresent() && isConfirmed(last.divergence().getAsLong(), now, from)) {
            return last;
        }
        OptionalLong divergence = now.firstDifference(last.reference().run().hashTrace(), from);
        return divergence.equals(last.divergence())
                ? last
                : new RunComparison(last.reference(), divergence, last.seedDiffers());
    }

    /**
     * Whether a divergence that was found stands: it lies behind what is new, or ahead of a run that was taken back to
     * an earlier moment and will come there again.
     */
    private boolean isConfirmed(long divergence, HashTrace now, int from) {
        return divergence < from || divergence >= now.size() && divergence <= navigator.furthestTick();
    }
}
