package faultline.gui.document;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.HashTrace;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.external.ControllerChoice;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * Compares the run with a reference run and finds the first tick in which they differ. Opening another scenario removes
 * the reference run. Event dispatch thread only.
 */
public final class ComparisonController implements WorkspaceListener {

    private final Workspace workspace;
    private final RunNavigator navigator;
    private RunComparison comparison;
    private HashTrace comparedHashes = HashTrace.EMPTY;
    /** Null if no reference run is being made. */
    private PendingReference pending;

    /** A reference run that is being made: its name, and the progress of its replay. */
    public record PendingReference(String name, TaskProgress progress) {}

    /** Creates the controller of a workspace, without a reference run. */
    public ComparisonController(Workspace workspace, RunNavigator navigator) {
        this.workspace = workspace;
        this.navigator = navigator;
        workspace.addListener(this);
    }

    @Override
    public void scenarioOpened() {
        removeReference();
    }

    @Override
    public void workspaceClosing() {
        cancelPendingTask();
    }

    /** Returns whether the run has ticks that can be kept as a reference run. */
    public boolean canCapture() {
        return navigator.furthestTick() > 0;
    }

    /**
     * Makes the run so far the reference run, asynchronously. With a controller that is not part of the program, its
     * recorded decisions are repeated, so the reference run ends at the present tick.
     */
    public void captureCurrentRun() {
        workspace.openDocument().ifPresent(now -> {
            CompletableFuture<Journal> executed = now.session().journal();
            CompletableFuture<Journal> whole = now.session().fullJournal();
            String name = now.document().initial().name();
            start(name, now.document().displayPath(), progress -> {
                Journal past = executed.join();
                boolean foreign = past.setup().controller() instanceof ControllerSpec.Foreign;
                return replay(name, foreign ? past.withRecordedController() : whole.join(), progress);
            });
        });
    }

    /** Runs the scenario of a file, such as a saved journal, and makes it the reference run, asynchronously. */
    public void loadReference(Path file) {
        start(FileNames.lastOf(file), file, progress -> {
            Scenario scenario = Scenario.load(file);
            SimulationSetup setup = scenario.setup();
            return replay(scenario.name(), new Journal(setup, List.of(), setup.ticks()), progress);
        });
    }

    /**
     * Runs the edited scenario from its start to its duration with another controller and makes that the reference run,
     * asynchronously. {@code errors} receives each line that a controller in another process writes to standard error,
     * until the reference run is cancelled or replaced by another one; {@code onStarted} is called with the setup of
     * the reference run when the controller has started.
     */
    public void compareWith(ControllerChoice controller, Consumer<String> errors, Consumer<SimulationSetup> onStarted) {
        workspace.openDocument().ifPresent(now -> {
            CompletableFuture<Scenario> edited = now.edited();
            String name =
                    controller.isScenarioDefault() ? now.document().edited().name() : controller.text();
            start(name, now.document().displayPath(), progress -> {
                Scenario scenario = edited.join();
                assert !EventQueue.isDispatchThread();
                Consumer<String> whileActive = line -> {
                    if (progress.isActive()) {
                        errors.accept(line);
                    }
                };
                SimulationSetup setup = controller.applyTo(scenario.setup(), scenario.name(), whileActive);
                return replay(
                        name, new Journal(setup, List.of(), setup.ticks()), progress, () -> onStarted.accept(setup));
            });
        });
    }

    private static RunComparison replay(String name, Journal journal, TaskProgress progress) {
        return replay(name, journal, progress, () -> {});
    }

    private static RunComparison replay(String name, Journal journal, TaskProgress progress, Runnable onStarted) {
        ReferenceRun run = ReferenceRun.replay(journal, tick -> {
            if (tick == 0) {
                EventQueue.invokeLater(onStarted);
            }
            progress.setFraction((double) tick / Math.max(1, journal.ticks()));
            return true;
        });
        return new RunComparison(name, run);
    }

    /** Replays a reference run. */
    private interface ReplayTask {
        RunComparison run(TaskProgress progress) throws ScenarioException;
    }

    /** Starts a task instead of the pending one, given the name of the reference run and the file of its scenario. */
    private void start(String name, Path file, ReplayTask replay) {
        cancelPendingTask();
        TaskProgress progress = new TaskProgress();
        pending = new PendingReference(name, progress);
        BackgroundTasks.compute(
                () -> progress.perform(() -> replay.run(progress)),
                made -> completeTask(progress, () -> setReference(made)),
                failure -> completeTask(
                        progress,
                        () -> workspace.fire(listener -> listener.taskFailed(TaskKind.GHOST, file, failure))));
        workspace.fire(WorkspaceListener::comparisonChanged);
    }

    private void completeTask(TaskProgress progress, Runnable outcome) {
        if (progress.isActive()) {
            pending = null;
            outcome.run();
            workspace.fire(WorkspaceListener::comparisonChanged);
        }
    }

    private void cancelPendingTask() {
        if (pending != null) {
            pending.progress().cancel();
            pending = null;
        }
    }

    private void setReference(RunComparison made) {
        comparedHashes = HashTrace.EMPTY;
        comparison = made;
    }

    /** Removes the reference run, and cancels the pending one. */
    public void removeReference() {
        cancelPendingTask();
        comparison = null;
        workspace.fire(WorkspaceListener::comparisonChanged);
    }

    /** Cancels the pending reference run, and returns to the last one if there is one. */
    public void cancelPending() {
        cancelPendingTask();
        workspace.fire(WorkspaceListener::comparisonChanged);
    }

    /** Returns the reference run that is being loaded. */
    public Optional<PendingReference> pending() {
        return Optional.ofNullable(pending);
    }

    /**
     * Compares the ticks since the last call with the reference run. Returns the comparison so far, the same object as
     * before if nothing is new; empty if there is no reference run, or if another one is being loaded.
     */
    public Optional<RunComparison> update(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        HashTrace now = frame.recording().hashTrace();
        if (comparison != null) {
            comparison = compare(comparison, now, now.isContinuationOf(comparedHashes) ? comparedHashes.size() : 0);
        }
        comparedHashes = now;
        return pending().isPresent() ? Optional.empty() : Optional.ofNullable(comparison);
    }

    private RunComparison compare(RunComparison last, HashTrace now, int from) {
        ReferenceRun run = last.run();
        RunEvent.Diverged divergence = last.divergence()
                .filter(known -> known.tick() < from)
                .or(() -> firstDifference(run, now, from))
                .or(() -> last.divergence().filter(known -> isAhead(known.tick(), now)))
                .orElse(null);
        boolean whole = now.size() > run.hashTrace().size();
        RunComparison result = new RunComparison(last.name(), run, divergence, whole, isOfOtherSeed(run));
        return result.equals(last) ? last : result;
    }

    private static Optional<RunEvent.Diverged> firstDifference(ReferenceRun run, HashTrace now, int from) {
        return now.firstDifference(run.hashTrace(), from).stream()
                .mapToObj(tick -> new RunEvent.Diverged(tick, run.setup().timeOf(tick)))
                .findFirst();
    }

    private boolean isOfOtherSeed(ReferenceRun run) {
        return workspace
                .scenario()
                .filter(scenario -> scenario.setup().seed() != run.setup().seed())
                .isPresent();
    }

    /** Returns whether a known divergence is ahead of a run that was moved back and will reach it again. */
    private boolean isAhead(long divergence, HashTrace now) {
        return divergence >= now.size() && divergence <= navigator.furthestTick();
    }
}
