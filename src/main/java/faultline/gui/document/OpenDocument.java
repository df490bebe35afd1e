package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.scenario.Scenario;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * A document and the session that runs it.
 *
 * @param ownController whether the session has the scenario's controller although another one may be chosen
 */
record OpenDocument(ScenarioDocument document, Session session, boolean ownController) {

    /**
     * Starts the first session of a document. A saved run has its own controller in this and all later sessions, until
     * another one is chosen.
     */
    static OpenDocument start(ScenarioDocument document, Workspace workspace) {
        return start(document, document.initial().recorded(), workspace, sessionOf(document));
    }

    /** Starts the first session of a document that replaces this one, because the run restarts. */
    OpenDocument restartedAs(ScenarioDocument restarted, Workspace workspace) {
        return start(restarted, ownController, workspace, sessionOf(restarted));
    }

    /** Starts another session of this document, given what starts it with the change of the controller in a setup. */
    OpenDocument withSession(Workspace workspace, Function<UnaryOperator<SimulationSetup>, Session> starter) {
        return start(document, ownController, workspace, starter);
    }

    private static Function<UnaryOperator<SimulationSetup>, Session> sessionOf(ScenarioDocument document) {
        return choice -> Session.start(choice.apply(document.initial().setup()));
    }

    private static OpenDocument start(
            ScenarioDocument document,
            boolean keepsController,
            Workspace workspace,
            Function<UnaryOperator<SimulationSetup>, Session> starter) {
        boolean own = keepsController && workspace.isChoiceTried();
        UnaryOperator<SimulationSetup> choice = own
                ? UnaryOperator.identity()
                : setup ->
                        workspace.withChosenController(setup, document.initial().name());
        return new OpenDocument(document, starter.apply(choice), own);
    }

    /**
     * Returns the ids of the sensors of the run, which are earlier ones if the simulation of a renaming was cancelled.
     */
    List<String> sensorIds() {
        return session.frame().snapshot().robot().sensorIds();
    }

    /**
     * Returns the first tick of the edited scenario that is not before a tick of the run: the ticks have another length
     * if a restart that changes them was cancelled. Any thread may call this.
     */
    long tickOfScenario(long tickOfRun) {
        SimulationSetup inRun = session.setup();
        SimulationSetup edited = document.initial().setup();
        return inRun.dt() == edited.dt() ? tickOfRun : edited.tickAt(inRun.timeOf(tickOfRun));
    }

    /** Returns the result of a command of the run with the {@linkplain #tickOfScenario tick of the edited scenario}. */
    CommandResult inTicksOfScenario(CommandResult result) {
        long tick = tickOfScenario(result.tick());
        if (tick == result.tick()) {
            return result;
        }
        return result.refusal()
                .<CommandResult>map(reason -> new CommandResult.Refused(tick, result.command(), reason))
                .orElseGet(() -> new CommandResult.Executed(tick, result.command(), result.effect(), result.inverse()));
    }

    /**
     * Returns the scenario as edited by all commands that have been sent, and by those that were waiting for their
     * answers. The future completes on the event dispatch thread, after their results. If the session has ended, these
     * are the edits that are known.
     */
    CompletableFuture<Scenario> edited() {
        // The session answers in order, so the results of earlier commands are already in the queue.
        return session.journal()
                .handleAsync(
                        (journal, ended) -> ended == null && document.awaitsCommands()
                                // Such as those of an undo, which are sent when the results arrive.
                                ? edited()
                                : CompletableFuture.completedFuture(document.edited()),
                        EventQueue::invokeLater)
                .thenCompose(Function.identity());
    }
}
