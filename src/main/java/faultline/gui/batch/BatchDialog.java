package faultline.gui.batch;

import faultline.campaign.run.CampaignRunner;
import faultline.external.ControllerChoice;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.Leaving;
import faultline.gui.form.FormDialog.FormProblem;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.scenario.Scenario;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.Timer;

/** A non-modal dialog that makes many runs of a scenario and shows their results. */
final class BatchDialog extends RunsDialog {

    private static final int POLL_MILLIS = 200;

    private final transient BatchSource source;
    private final BatchForm form;
    private final JButton start = button("batch.start", this::start);
    private final JButton cancel = button("batch.cancel", this::cancel);
    private final JButton resume = button("batch.continue", this::resume);
    private final JButton savePlan = button("batch.savePlan", this::savePlan);
    private final JButton saveResults = button("batch.saveResults", () -> saveResults(() -> {}));
    private final JButton reopen = button("batch.reopen", this::reopen);
    private final JButton close = button("dialog.close", this::close);
    private final Timer poll = new Timer(POLL_MILLIS, event -> update());
    /** Null before the first batch. */
    private transient BatchRun run;
    /** Another object each time that runs are made: results that a user gives up are no later ones. */
    private transient Object resultsKey = new Object();
    /** The controller of the batch. */
    private transient ControllerChoice controller = ControllerChoice.SCENARIO;

    private boolean running;
    /** Whether the batch has been stopped before its last run. */
    private boolean stopped;
    /** Returns how the batch ended, in the current language; null before the end. */
    private transient Supplier<String> endText;
    /** Runs when the batch has ended, null for nothing. */
    private transient Runnable afterEnd;
    /** The number of plans and results that are being written. */
    private int writes;

    private boolean saved = true;

    /** Creates a dialog for runs of a scenario that is not yet visible; its controller is that of the scenario. */
    BatchDialog(Window owner, BatchSource source, BatchActions actions) {
        this(owner, source, actions, ControllerChoice.SCENARIO, false);
    }

    /**
     * Creates a dialog for runs of a scenario that is not yet visible, given the controller that drives the robot of
     * the window and whether it is a program.
     */
    BatchDialog(
            Window owner, BatchSource source, BatchActions actions, ControllerChoice chosen, boolean startsProgram) {
        super(owner, actions);
        this.source = source;
        form = new BatchForm(source.scenario());
        form.setChosen(chosen, startsProgram);
        UiText.addTab(tabs(), "batch.tab.plan", form);
        RefreshSteps.add(
                getRootPane(),
                root -> setTitle(Messages.get("batch.title", source.scenario().name())));
        UiText.tip(resume, "batch.continue.tip");
        UiText.tip(reopen, "batch.reopen.tip");
        reopen.setEnabled(false);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                form.focusFirstField();
            }
        });
        getRootPane().setDefaultButton(start);
        setRunning(false);
        layOut(List.of(start, cancel, resume, savePlan, saveResults, reopen, close));
    }

    /** Returns whether the dialog is for a scenario. */
    boolean isFor(Scenario other) {
        return source.scenario().equals(other);
    }

    /** Offers the controller that drives the robot of the window, given whether it is a program. */
    void setChosen(ControllerChoice chosen, boolean startsProgram) {
        form.setChosen(chosen, startsProgram);
    }

    private void setRunning(boolean now) {
        running = now;
        enableStart();
        cancel.setEnabled(now);
        BatchResults results = resultsOrNull();
        saveResults.setEnabled(!now && results != null && results.size() > 0);
    }

    /** Allows more runs unless files are being written: they would change or delete those that are being copied. */
    private void enableStart() {
        start.setEnabled(!running && writes == 0);
        resume.setEnabled(!running && writes == 0 && stopped);
    }

    private Optional<BatchPlan> checkedPlan() {
        Optional<FormProblem> problem = form.findProblem();
        problem.ifPresent(found -> {
            found.field().requestFocusInWindow();
            showProblem(found.sentence());
        });
        return problem.isEmpty() ? Optional.of(form.plan()) : Optional.empty();
    }

    private void start() {
        runIfResultsHandled(this::startHandled);
    }

    private void startHandled() {
        checkedPlan().ifPresent(plan -> {
            discardRun();
            run = new BatchRun(plan, form.jobs());
            controller = form.controllerChoice();
            saved = true;
            endText = null;
            make(run);
        });
    }

    /** Makes the other runs of a batch that has been stopped. */
    private void resume() {
        if (stopped && !running && writes == 0) {
            boolean focused = resume.isFocusOwner();
            run.prepareToContinue();
            make(run);
            if (focused) {
                // A button that is disabled passes the focus to the next one, which saves the plan.
                cancel.requestFocusInWindow();
            }
        }
    }

    private void make(BatchRun made) {
        resultsKey = new Object();
        ControllerChoice driving = controller;
        stopped = false;
        setRunning(true);
        progress().begin();
        progress().showStatus(() -> Messages.get("batch.checking"));
        poll.start();
        BackgroundTasks.computeBeforeExit(
                () -> driving.callWithJars(made::make),
                result -> ended(made, result),
                failure -> failed(made, failure));
    }

    private void cancel() {
        if (running) {
            run.progress().cancel();
            progress().showStatus(() -> Messages.get("batch.cancelling"));
        }
    }

    private void ended(BatchRun ended, CampaignRunner.RunCounts result) {
        running = false;
        if (!isDisplayable()) {
            delete(ended);
            return;
        }
        update();
        resultTabsOrNull().keepRows((int) result.made());
        stopped = !result.isComplete();
        stopProgress();
        endText = () -> BatchProgressPanel.endText(result, ended.completion().seconds(), ended.repeatCount());
        progress().showStatus(endText);
        if (afterEnd != null) {
            afterEnd.run();
            afterEnd = null;
        }
    }

    private void failed(BatchRun failed, Throwable failure) {
        running = false;
        if (!isDisplayable()) {
            delete(failed);
            return;
        }
        update();
        BatchRun.Completion completion = failed.completion();
        stopped = failed.planOrNull() != null && completion.made() < completion.runs();
        stopProgress();
        afterEnd = null;
        progress().showStatus(endText == null ? () -> " " : endText);
        showProblem(
                failure instanceof BatchRun.ChangedException
                        ? Messages.get("batch.continue.changed")
                        : ErrorMessages.describe(failure));
    }

    private void stopProgress() {
        poll.stop();
        progress().end();
        setRunning(false);
    }

    /** Shows the results since the last call. */
    private void update() {
        if (resultsOrNull() == null && run.planOrNull() != null) {
            showResults(new BatchResults(run.planOrNull()), controller);
        }
        BatchResults results = resultsOrNull();
        if (results != null) {
            for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
                resultTabsOrNull().add(row);
                saved = false;
            }
            resultTabsOrNull().update(run.cells());
            progress().show(run.completion(), run.progress().isActive());
        }
    }

    @Override
    void runOpened() {
        super.runOpened();
        reopen.setEnabled(true);
    }

    private void reopen() {
        source.reopen().run();
    }

    private void savePlan() {
        checkedPlan().ifPresent(plan -> actions()
                .choosePlanFile(source)
                .ifPresent(file -> write(file, () -> plan.save(file), () -> {})));
    }

    /** Saves the results, after the batch has been stopped if it is still being made; {@code then} runs afterwards. */
    private void saveResults(Runnable then) {
        BatchRun made = run;
        actions().chooseResultsFolder(source).ifPresent(folder -> {
            Runnable save = () -> write(folder, () -> made.saveResults(folder), () -> {
                saved = saved || run == made;
                then.run();
            });
            if (running) {
                afterEnd = save;
                cancel();
            } else {
                save.run();
            }
        });
    }

    /** Writes a file or a folder in the background. No run can be started during that time. */
    void write(Path target, BackgroundTasks.Work work, Runnable onWritten) {
        writes++;
        enableStart();
        BatchRun written = run;
        BackgroundTasks.performBeforeExit(
                work,
                () -> {
                    endWriting(written);
                    progress().showSaved(String.valueOf(target.getFileName()));
                    onWritten.run();
                },
                failure -> {
                    endWriting(written);
                    if (isDisplayable()) {
                        showProblem(Messages.get(
                                "failed.SAVE",
                                String.valueOf(target.getFileName()),
                                ErrorMessages.describe(failure, target)));
                    }
                });
    }

    /** Deletes a batch whose dialog was closed while it was written. */
    private void endWriting(BatchRun written) {
        writes--;
        enableStart();
        if (!isDisplayable() && written != null && !isInUse()) {
            delete(written);
        }
    }

    /** Returns whether the files of the batch are being made or copied. */
    private boolean isInUse() {
        return running || writes > 0;
    }

    /** Runs an action that would lose unsaved results, after asking whether to save them. */
    void runIfResultsHandled(Leaving leaving, Runnable action) {
        if (saved || leaving.isDiscarded(resultsKey)) {
            action.run();
            return;
        }
        String question = Messages.get(running ? "batch.loss.running" : "batch.loss");
        int answer =
                Dialogs.ask(this, getTitle(), question, "batch.saveResults", "batch.loss.discard", "unsaved.cancel");
        if (answer == 0) {
            saveResults(leaving::ask);
        } else if (answer == 1) {
            leaving.discard(resultsKey);
            action.run();
        }
    }

    @Override
    void close() {
        runIfResultsHandled(this::disposeAndFocusOwner);
    }

    private void runIfResultsHandled(Runnable action) {
        Leaving.begin(leaving -> {
            // The dialog may have been closed while the results were saved.
            if (isDisplayable()) {
                runIfResultsHandled(leaving, action);
            }
        });
    }

    private void discardRun() {
        if (run != null) {
            delete(run);
        }
        removeResults();
    }

    private static void delete(BatchRun ended) {
        BackgroundTasks.performBeforeExit(ended::delete, () -> {}, failure -> {});
    }

    /** Cancels the batch and deletes its files. */
    @Override
    public void dispose() {
        poll.stop();
        if (run != null) {
            run.progress().cancel();
            if (!isInUse()) {
                delete(run);
            }
            run = null;
        }
        super.dispose();
    }
}
