package faultline.gui.batch;

import faultline.campaign.run.Outcome;
import faultline.campaign.run.ReplayScenario;
import faultline.control.ControllerSpec;
import faultline.external.ControllerChoice;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.dialog.ControllerActions;
import faultline.gui.dialog.Dialogs;
import faultline.gui.dialog.FileController;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.Leaving;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.Timer;

/** The actions that open the batch of the open scenario and earlier results, and what their dialogs need. */
public final class BatchActions {

    /** The time after which a note says that results are being read. */
    private static final int MILLIS_BEFORE_NOTE = 1000;

    private final Window owner;
    private final FileController files;
    private final ControllerActions controllers;
    private final Consumer<String> note;
    /** The dialogs that are hidden because one of their runs has been opened in the window, the newest at the end. */
    private final List<RunsDialog> hidden = new ArrayList<>();

    /** Creates the actions of a window; {@code note} shows a sentence to the user. */
    public BatchActions(Window owner, FileController files, ControllerActions controllers, Consumer<String> note) {
        this.owner = owner;
        this.files = files;
        this.controllers = controllers;
        this.note = note;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("batch", this::showDialog).withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_B)));
        actions.add(UiAction.of("openBatchResults", this::openResults));
    }

    /** Runs an action that would lose the unsaved results of all batches, after asking whether to save them. */
    public void runIfResultsHandled(Leaving leaving, Runnable action) {
        Runnable rest = action;
        for (BatchDialog dialog : dialogs().toList()) {
            Runnable next = rest;
            rest = () -> dialog.runIfResultsHandled(leaving, next);
        }
        rest.run();
    }

    private Stream<BatchDialog> dialogs() {
        return Stream.of(owner.getOwnedWindows())
                .filter(BatchDialog.class::isInstance)
                .map(BatchDialog.class::cast)
                .filter(BatchDialog::isDisplayable);
    }

    /** Called when a scenario has been opened. Hidden results stay hidden; a note says how they show again. */
    public void scenarioOpened() {
        if (!hidden.isEmpty()) {
            note.accept(Keystrokes.withMenuModifier(Messages.get("batch.hidden")));
        }
    }

    private RunsDialog newestHiddenOrNull() {
        return hidden.isEmpty() ? null : hidden.get(hidden.size() - 1);
    }

    /**
     * Shows the results again that were hidden last, or else the dialog of the open scenario as it is now; a batch of
     * another scenario keeps its own dialog.
     */
    private void showDialog() {
        if (newestHiddenOrNull() instanceof ResultsDialog results) {
            bringToFront(results);
            return;
        }
        Path stem = files.suggestedFile("");
        Consumer<Scenario> reopening = files.reopening();
        ControllerChoice chosen = controllers.chosen();
        // If a jar is broken by now, the batch says so when it starts.
        boolean program = controllers.startsProgram();
        files.editedScenario()
                .ifPresent(edited -> edited.thenAccept(open ->
                        showDialog(new BatchSource(open, stem, () -> reopening.accept(open)), chosen, program)));
    }

    private void showDialog(BatchSource open, ControllerChoice chosen, boolean startsProgram) {
        if (!owner.isDisplayable()) {
            return;
        }
        RunsDialog newest = newestHiddenOrNull();
        dialogs()
                .filter(dialog -> newest == null ? dialog.isFor(open.scenario()) : dialog == newest)
                .findFirst()
                .ifPresentOrElse(
                        known -> {
                            known.setChosen(chosen, startsProgram);
                            bringToFront(known);
                        },
                        () -> new BatchDialog(owner, open, this, chosen, startsProgram).setVisible(true));
    }

    /**
     * Opens the run of a row in the window, given the controller of the results, and hides the dialog when it is open.
     */
    void openRun(RunsDialog dialog, BatchResults results, int row, ControllerChoice controller) {
        int run = Math.toIntExact(results.run(row));
        Outcome outcome = Outcome.ofWord(results.value(row, "outcome")).orElseThrow();
        double seconds = Double.parseDouble(results.value(row, "simulated_s"));
        BackgroundTasks.compute(
                () -> controller.callWithJars(() -> ReplayScenario.of(results.plan(), run, outcome, seconds)),
                opened -> {
                    if (owner.isDisplayable()) {
                        openRun(dialog, named(opened, run), controller.jars());
                    }
                },
                failure -> dialog.showProblem(ErrorMessages.describe(failure)));
    }

    /** Returns the scenario of a run, with its name in the language of the window. */
    static Scenario named(Scenario run, int index) {
        return run.withName(Messages.get("batch.run", Integer.toString(index)));
    }

    /**
     * Opens a run in the window, with the controller that it was made with: that of its scenario, which some jars may
     * contain.
     */
    private void openRun(RunsDialog dialog, Scenario run, List<Path> jars) {
        String name = !jars.isEmpty() && run.setup().controller() instanceof ControllerSpec.Provided provided
                ? provided.name()
                : "";
        List<Path> kept = jars.isEmpty() ? controllers.jars() : jars;
        files.runIfChangesHandled(() -> {
            controllers.selectForOpening(new ControllerChoice(name, kept));
            files.openGeneratedWithoutAsking(run, () -> {
                hide(dialog);
                // Opening removes the notes about the scenario before.
                note.accept(Keystrokes.withMenuModifier(Messages.get("batch.opened")));
            });
        });
    }

    private void bringToFront(RunsDialog dialog) {
        hidden.remove(dialog);
        dialog.bringToFront();
    }

    private void hide(RunsDialog dialog) {
        if (dialog.isDisplayable()) {
            hidden.remove(dialog);
            hidden.add(dialog);
            dialog.runOpened();
        }
    }

    private void openResults() {
        files.chooseResults("openBatchResults").ifPresent(this::openResults);
    }

    /** Reads results in the background, given their folder or one of its files, and shows them. */
    void openResults(Path chosen) {
        ControllerChoice jars = new ControllerChoice("", controllers.jars());
        String name = OpenedResults.nameOf(chosen);
        Timer reading = new Timer(MILLIS_BEFORE_NOTE, event -> note.accept(Messages.get("batch.opened.reading", name)));
        reading.setRepeats(false);
        reading.start();
        BackgroundTasks.compute(
                () -> jars.callWithJars(() -> OpenedResults.read(chosen)),
                opened -> {
                    reading.stop();
                    showResults(opened, jars.jars());
                },
                failure -> {
                    reading.stop();
                    if (owner.isDisplayable()) {
                        Dialogs.showWarning(owner, OpenedResults.failureText(chosen, failure));
                    }
                });
    }

    /** Shows results; they replace those that were read earlier from the same folder. */
    private void showResults(OpenedResults opened, List<Path> jars) {
        if (!owner.isDisplayable()) {
            return;
        }
        Stream.of(owner.getOwnedWindows())
                .filter(window ->
                        window instanceof ResultsDialog known && known.folder().equals(opened.folder()))
                .forEach(this::dispose);
        new ResultsDialog(owner, opened, jars, this).setVisible(true);
    }

    private void dispose(Window dialog) {
        hidden.removeIf(other -> other == dialog);
        dialog.dispose();
    }

    /** Asks for the file of a plan; empty if cancelled. */
    Optional<Path> choosePlanFile(BatchSource source) {
        return files.chooseFile("batchPlan", source.file("-batch.xml"));
    }

    /** Asks for the folder of results; empty if cancelled. */
    Optional<Path> chooseResultsFolder(BatchSource source) {
        return files.chooseNewFolder("batchResults", source.file("-batch"));
    }
}
