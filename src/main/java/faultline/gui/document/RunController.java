package faultline.gui.document;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** What is done to the run on the bench, and what is seen of it. */
public final class RunController {

    private final Workspace workspace;
    private final RunNavigator navigator;
    private final DirtyTracker dirtyTracker;
    private final List<Consumer<Session>> deferredRequests = new ArrayList<>();
    private double speed = 1;

    /**
     * For a bench.
     *
     * @param bench whose run
     */
    public RunController(Workspace bench) {
        this.workspace = bench;
        navigator = new RunNavigator(bench);
        dirtyTracker = new DirtyTracker(bench);
        bench.addSessionListener(new SessionInitializer());
    }

    /** Makes each new session one like the last, and gives it what was meant for it before it was there. */
    private final class SessionInitializer implements Workspace.SessionListener {
        @Override
        public void sessionStarted(TaskKind task, OpenDocument made) {
            if (task == TaskKind.OPEN) {
                // They were meant for the scenario before.
                deferredRequests.clear();
            }
            made.session().setSpeed(speed);
            navigator.sessionStarted(task, made.document().initial());
            navigator.replayEnd().ifPresent(made.session()::pauseAt);
            dirtyTracker.markStale();
        }

        @Override
        public void taskFinished() {
            List<Consumer<Session>> orders = List.copyOf(deferredRequests);
            deferredRequests.clear();
            orders.forEach(RunController.this::submit);
        }
    }

    /**
     * Orders something of the run. While the same scenario is on its way to another moment or to a new beginning,
     * orders wait: what the old session were told now would be lost with it.
     */
    private void submit(Consumer<Session> order) {
        if (workspace.taskProgress().filter(way -> way.task() != TaskKind.OPEN).isPresent()) {
            deferredRequests.add(order);
        } else {
            session().ifPresent(order);
        }
    }

    /**
     * The way to other moments of the run.
     *
     * @return the same for every session
     */
    public RunNavigator navigator() {
        return navigator;
    }

    /** Begins anew, soon, with the scenario as it is edited by now. */
    public void restart() {
        restart(UnaryOperator.identity());
    }

    /**
     * Begins anew, soon, with the scenario as it is edited by now and the robot elsewhere.
     *
     * @param start where the robot starts; there is room for it
     */
    public void restartAt(Pose start) {
        restart(setup -> setup.withStart(start));
    }

    private void restart(UnaryOperator<SimulationSetup> change) {
        workspace.openDocument().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().fullJournal();
            ScenarioDocument document = now.document();
            workspace.startTask(TaskKind.RESTART, document.displayPath(), way -> {
                Scenario edited = document.editedBy(journal.join());
                return OpenDocument.create(ScenarioDocument.create(
                        document.file(), document.saved(), edited.withSetup(change.apply(edited.setup()))));
            });
        });
    }

    /**
     * The newest frame; asking orders the next one.
     *
     * @return empty before the first session
     */
    public Optional<SessionFrame> frame() {
        dirtyTracker.refresh();
        Optional<SessionFrame> newest =
                workspace.openDocument().map(now -> now.session().frame());
        newest.ifPresent(frame -> navigator.frameReached(frame.frame()));
        return newest;
    }

    /**
     * How the run is.
     *
     * @return empty before the first session
     */
    public Optional<Session.Status> status() {
        return session().map(Session::status);
    }

    /**
     * Gives several commands to the run, which are carried out at the start of the same tick.
     *
     * @param commands what is to be done, in order
     * @param told gets what became of each, on the event dispatch thread, soon; never, where there is no run
     */
    public void send(List<Command> commands, Consumer<List<CommandResult>> told) {
        submit(session -> session.send(
                commands,
                outcomes -> EventQueue.invokeLater(() -> {
                    commandsExecuted(outcomes);
                    told.accept(outcomes);
                })));
    }

    private void commandsExecuted(List<CommandResult> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty())) {
            dirtyTracker.markStale();
            navigator.discardFuture();
            session().ifPresent(Session::clearPauseTick);
        }
    }

    /** Lets time run, or holds it. */
    public void toggleRunning() {
        submit(session -> {
            if (session.status().running()) {
                session.pause();
            } else {
                session.resume();
            }
        });
    }

    /** Makes one tick and holds. */
    public void step() {
        submit(Session::step);
    }

    /**
     * Sets the pace of this run and of all that follow.
     *
     * @param factor times real time, positive; positive infinity for as fast as possible
     */
    public void setSpeed(double factor) {
        speed = factor;
        session().ifPresent(session -> session.setSpeed(factor));
    }

    private Optional<Session> session() {
        return workspace.openDocument().map(OpenDocument::session);
    }
}
