package faultline.gui.batch;

import faultline.control.ControllerSpec;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.dialog.ControllerChooser;
import faultline.gui.dialog.FileController;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.ControllerSelection;
import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JOptionPane;

/** The action that opens the batch of the open scenario, and what its dialog needs of the window. */
public final class BatchActions {

    private final Window owner;
    private final FileController files;
    private final ControllerChooser controllers;
    private final Consumer<String> note;

    /** Creates the actions of a window; {@code note} shows a sentence to the user. */
    public BatchActions(Window owner, FileController files, ControllerChooser controllers, Consumer<String> note) {
        this.owner = owner;
        this.files = files;
        this.controllers = controllers;
        this.note = note;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("batch", this::showDialog).withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_B)));
    }

    /** Runs an action that would lose the unsaved results of all batches, after asking whether to save them. */
    public void runIfResultsHandled(Runnable action) {
        Runnable rest = action;
        for (BatchDialog dialog : dialogs().toList()) {
            Runnable next = rest;
            rest = () -> dialog.runIfResultsHandled(next);
        }
        rest.run();
    }

    private Stream<BatchDialog> dialogs() {
        return Stream.of(owner.getOwnedWindows())
                .filter(BatchDialog.class::isInstance)
                .map(BatchDialog.class::cast)
                .filter(BatchDialog::isDisplayable);
    }

    /** Shows the dialog of the open scenario as it is now; a batch of another scenario keeps its own dialog. */
    private void showDialog() {
        Path stem = files.suggestedFile("");
        Consumer<Scenario> reopening = files.reopening();
        ControllerSelection chosen = controllers.chosen();
        files.editedScenario()
                .ifPresent(edited -> edited.thenAccept(
                        open -> showDialog(new BatchSource(open, stem, () -> reopening.accept(open)), chosen)));
    }

    private void showDialog(BatchSource open, ControllerSelection chosen) {
        if (chosen.isScenarios()) {
            showDialog(open, chosen, false);
        } else {
            // If a jar is broken by now, the batch says so when it starts.
            BackgroundTasks.run(
                    chosen::startsProgram,
                    program -> showDialog(open, chosen, program),
                    failure -> showDialog(open, chosen, false));
        }
    }

    private void showDialog(BatchSource open, ControllerSelection chosen, boolean startsProgram) {
        if (!owner.isDisplayable()) {
            return;
        }
        dialogs()
                .filter(dialog -> dialog.isFor(open.scenario()))
                .findFirst()
                .ifPresentOrElse(
                        known -> {
                            known.setChosen(chosen, startsProgram);
                            known.bringToFront();
                        },
                        () -> new BatchDialog(owner, open, this, chosen, startsProgram).setVisible(true));
    }

    /**
     * Opens a run in the window, with the controller that it was made with: that of its scenario, which some jars may
     * contain.
     */
    void openRun(Scenario run, List<Path> jars) {
        String name = !jars.isEmpty() && run.setup().controller() instanceof ControllerSpec.Provided provided
                ? provided.name()
                : "";
        List<Path> kept = jars.isEmpty() ? controllers.jars() : jars;
        files.runIfChangesHandled(() -> {
            controllers.select(new ControllerSelection(name, kept));
            // Opening removes the notes about the scenario before.
            files.openGeneratedWithoutAsking(
                    run, () -> note.accept(Keystrokes.withMenuModifier(Messages.get("batch.opened"))));
        });
    }

    /** Asks for the file of a plan; empty if cancelled. */
    Optional<Path> choosePlanFile(BatchSource source) {
        return files.chooseFile("batchPlan", source.file("-batch.xml"));
    }

    /** Asks for the folder of results; empty if cancelled. */
    Optional<Path> chooseResultsFolder(BatchSource source) {
        return files.chooseNewFolder("batchResults", source.file("-batch"));
    }

    void showProblem(Component parent, String sentence) {
        JOptionPane.showMessageDialog(
                parent, TextWrap.wrap(sentence), Messages.get("failed.title"), JOptionPane.WARNING_MESSAGE);
    }
}
