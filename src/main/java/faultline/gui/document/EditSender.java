package faultline.gui.document;

import faultline.gui.change.EditedSetup;
import faultline.gui.change.LaterChange;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** Sends the commands of edits to the run, and applies their results to the scenario. Event dispatch thread only. */
final class EditSender {

    private final Workspace workspace;
    private final RunNavigator navigator;

    EditSender(Workspace workspace, RunNavigator navigator) {
        this.workspace = workspace;
        this.navigator = navigator;
    }

    /**
     * Sends commands as {@link RunController#send} describes, which have the ids of obstacles after a number of changes
     * of them.
     */
    void send(OpenDocument open, List<Command> commands, int renames, Consumer<List<CommandResult>> onExecuted) {
        if (!isRunning(open, onExecuted)) {
            return;
        }
        sendNamed(
                open,
                commands.stream(),
                renames,
                results -> EventQueue.invokeLater(() -> {
                    List<CommandResult> named = results.stream()
                            .map(result -> open.document().named(open.inTicksOfScenario(result)))
                            .toList();
                    commandsExecuted(open, named);
                    onExecuted.accept(
                            named.stream().map(EditedSetup::withoutSwitch).toList());
                }));
    }

    /** Returns whether the run can execute an edit; otherwise, {@code onExecuted} receives no results. */
    private static boolean isRunning(OpenDocument open, Consumer<List<CommandResult>> onExecuted) {
        boolean ended = open.session().hasEnded();
        if (ended) {
            EventQueue.invokeLater(() -> onExecuted.accept(List.of()));
        }
        return !ended;
    }

    /**
     * Sends commands with the ids that the run's sensors and obstacles have; {@code onResults} is called on the run's
     * thread.
     */
    private static void sendNamed(
            OpenDocument open, Stream<Command> commands, int renames, Consumer<List<CommandResult>> onResults) {
        ScenarioDocument document = open.document();
        document.commandsSent();
        List<String> ids = open.sensorIds();
        open.session()
                .send(
                        commands.map(command -> document.renames().inRun(command, renames, ids))
                                .toList(),
                        onResults);
    }

    private void commandsExecuted(OpenDocument open, List<CommandResult> results) {
        boolean executed = isAnyExecuted(results);
        answered(open, () -> {
            if (executed) {
                open.document().commandsExecuted(results);
            }
        });
        if (executed) {
            discardFuture(open);
        }
    }

    private static boolean isAnyExecuted(List<CommandResult> results) {
        return results.stream().anyMatch(result -> result.refusal().isEmpty());
    }

    /** Notes that commands have been answered, given what makes the changes of the scenario. */
    private void answered(OpenDocument open, Runnable changes) {
        open.document().commandsAnswered();
        boolean changedBefore = open.document().isChanged();
        changes.run();
        if (open.document().isChanged() != changedBefore) {
            workspace.fire(WorkspaceListener::titleChanged);
        }
    }

    private void discardFuture(OpenDocument open) {
        if (workspace.openDocument().filter(open::equals).isPresent()) {
            navigator.discardFuture();
        }
    }

    /** Sends what remains of later changes in the run, as {@link RunController#changeLater} describes. */
    void changeLater(OpenDocument open, List<LaterChange> changes, Consumer<List<CommandResult>> onExecuted) {
        if (!isRunning(open, onExecuted)) {
            return;
        }
        CompletableFuture<List<CommandResult>> executed = new CompletableFuture<>();
        sendNamed(
                open,
                changes.stream().flatMap(change -> Stream.ofNullable(change.inRun())),
                open.document().renames().changesOfObstacles(),
                executed::complete);
        // The session answers in order, so the results are there.
        open.session()
                .journal()
                .whenComplete((journal, ended) -> EventQueue.invokeLater(() -> {
                    long ticks = journal == null ? navigator.currentTick() : journal.ticks();
                    onExecuted.accept(changedLater(open, changes, executed.getNow(List.of()), ticks + 1));
                }));
    }

    /** Applies the results of later changes, given those of the run, and returns them. */
    private List<CommandResult> changedLater(
            OpenDocument open, List<LaterChange> changes, List<CommandResult> executed, long tick) {
        ScenarioDocument document = open.document();
        Iterator<CommandResult> ofRun = executed.iterator();
        List<CommandResult> results = new ArrayList<>();
        answered(open, () -> {
            for (LaterChange change : changes) {
                boolean sent = change.inRun() != null;
                if (sent && !ofRun.hasNext()) {
                    // The run has died.
                    return;
                }
                CommandResult result = sent
                        ? document.named(open.inTicksOfScenario(ofRun.next()))
                        : open.inTicksOfScenario(executedAt(tick, change.inScenario()));
                CommandResult edit = EditedSetup.withoutSwitch(result);
                results.add(edit);
                if (result.refusal().isEmpty()) {
                    document.changedLater(result.tick(), change.resultInScenario(edit), sent ? result : null);
                }
            }
        });
        if (isAnyExecuted(executed)) {
            discardFuture(open);
        }
        return results;
    }

    private static CommandResult executedAt(long tick, CommandResult result) {
        return new CommandResult.Executed(tick, result.command(), result.effect(), result.inverse());
    }
}
