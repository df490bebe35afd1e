package faultline.gui.batch;

import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.RunScenario;
import faultline.gui.dialog.Dialogs;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.ControllerSelection;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import faultline.scenario.Scenario;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.Timer;

/**
 * A non-modal dialog that makes many runs of a scenario and shows their results. It is hidden while the user looks at
 * one of its runs in the window.
 */
final class BatchDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(1080, 620);
    private static final int POLL_MILLIS = 200;

    private final transient BatchSource source;
    private final transient BatchActions actions;
    private final BatchForm form;
    private final JTabbedPane tabs = new JTabbedPane();
    private final BatchProgressPanel progress = new BatchProgressPanel();
    private final JButton start = button("batch.start", this::start);
    private final JButton cancel = button("batch.cancel", this::cancel);
    private final JButton savePlan = button("batch.savePlan", this::savePlan);
    private final JButton saveResults = button("batch.saveResults", () -> saveResults(() -> {}));
    private final JButton reopen = button("batch.reopen", this::reopen);
    private final JButton close = button("dialog.close", this::close);
    private final Timer poll = new Timer(POLL_MILLIS, event -> update());
    /** Null before the first batch. */
    private transient BatchRun run;
    /** Null until the plan of the batch has been read. */
    private transient BatchResults results;

    private transient ResultTabs resultTabs;
    /** The controller of the results. */
    private transient ControllerSelection controller = ControllerSelection.SCENARIO;

    private boolean running;
    /** Runs when the batch has ended, null for nothing. */
    private transient Runnable afterEnd;
    /** The number of plans and results that are being written. */
    private int writes;

    private boolean saved = true;

    /** Creates a dialog for runs of a scenario that is not yet visible; its controller is that of the scenario. */
    BatchDialog(Window owner, BatchSource source, BatchActions actions) {
        this(owner, source, actions, ControllerSelection.SCENARIO, false);
    }

    /**
     * Creates a dialog for runs of a scenario that is not yet visible, given the controller that drives the robot of
     * the window and whether it is a program.
     */
    BatchDialog(
            Window owner, BatchSource source, BatchActions actions, ControllerSelection chosen, boolean startsProgram) {
        super(owner, ModalityType.MODELESS);
        assert EventQueue.isDispatchThread();
        this.source = source;
        this.actions = actions;
        form = new BatchForm(source.scenario());
        form.setChosen(chosen, startsProgram);
        UiText.addTab(tabs, "batch.tab.plan", form);
        UiText.name(tabs, "batch.tabs");
        RefreshSteps.add(
                getRootPane(),
                root -> setTitle(Messages.get("batch.title", source.scenario().name())));
        JPanel content = new JPanel(new BorderLayout(0, 8));
        content.setBorder(BorderFactory.createEmptyBorder(8, 12, 8, 12));
        content.add(tabs, BorderLayout.CENTER);
        content.add(createFooter(), BorderLayout.SOUTH);
        setContentPane(content);
        UiText.tip(reopen, "batch.reopen.tip");
        reopen.setEnabled(false);
        installClosing();
        setRunning(false);
        int width = Math.max(TextSize.scaled(SIZE.width), content.getPreferredSize().width);
        content.setPreferredSize(new Dimension(width, TextSize.scaled(SIZE.height)));
        ScreenFit.pack(this);
        setLocationRelativeTo(owner);
    }

    private void installClosing() {
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                form.focusFirstField();
            }

            @Override
            public void windowClosing(WindowEvent event) {
                close();
            }
        });
        DialogButtons.onEscape(this, this::close);
        getRootPane().setDefaultButton(start);
    }

    private static JButton button(String key, Runnable action) {
        JButton button = UiText.button(key);
        button.addActionListener(event -> action.run());
        return button;
    }

    private JPanel createFooter() {
        JPanel buttons = new WrappedRow();
        List.of(start, cancel, savePlan, saveResults, reopen, close).forEach(buttons::add);
        JPanel footer = new JPanel(new BorderLayout(0, 4));
        footer.add(progress, BorderLayout.CENTER);
        footer.add(buttons, BorderLayout.SOUTH);
        return footer;
    }

    /** Returns whether the dialog is for a scenario, or hidden because the user looks at one of its runs. */
    boolean isFor(Scenario other) {
        return source.scenario().equals(other) || !isShowing();
    }

    /** Offers the controller that drives the robot of the window, given whether it is a program. */
    void setChosen(ControllerSelection chosen, boolean startsProgram) {
        form.setChosen(chosen, startsProgram);
    }

    /** Shows the dialog where the user left it. */
    void bringToFront() {
        setVisible(true);
        toFront();
        requestFocus();
        if (resultTabs != null) {
            resultTabs.focusTable();
        }
    }

    private void setRunning(boolean now) {
        running = now;
        enableStart();
        cancel.setEnabled(now);
        saveResults.setEnabled(!now && results != null && results.size() > 0);
    }

    /** Allows another run unless files are being written: it would delete those that are being copied. */
    private void enableStart() {
        start.setEnabled(!running && writes == 0);
    }

    private Optional<BatchPlan> checkedPlan() {
        Optional<String> problem = form.findProblem();
        problem.ifPresent(this::showProblem);
        return problem.isEmpty() ? Optional.of(form.plan()) : Optional.empty();
    }

    private void start() {
        runIfResultsHandled(() -> {
            // The dialog may have been closed while the results were saved.
            if (isDisplayable()) {
                startHandled();
            }
        });
    }

    private void startHandled() {
        checkedPlan().ifPresent(plan -> {
            discardRun();
            BatchRun started = new BatchRun(plan, form.jobs());
            run = started;
            controller = form.controllerSelection();
            ControllerSelection made = controller;
            saved = true;
            setRunning(true);
            progress.showStatus(() -> Messages.get("batch.checking"));
            progress.begin();
            poll.start();
            BackgroundTasks.runBeforeExit(
                    () -> made.callWithJars(started::make),
                    result -> ended(started, result),
                    failure -> failed(started, failure));
        });
    }

    private void cancel() {
        if (running) {
            run.progress().cancel();
            progress.showStatus(() -> Messages.get("batch.cancelling"));
        }
    }

    private void ended(BatchRun ended, CampaignRunner.RunCounts result) {
        running = false;
        if (!isDisplayable()) {
            delete(ended);
            return;
        }
        update();
        stopProgress();
        progress.showStatus(
                () -> BatchProgressPanel.endText(result, ended.completion().seconds(), ended.repeatCount()));
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
        stopProgress();
        afterEnd = null;
        progress.showStatus(() -> " ");
        showFailure(failure);
    }

    private void stopProgress() {
        poll.stop();
        progress.end();
        setRunning(false);
    }

    /** Shows the results since the last call. */
    private void update() {
        if (results == null && run.planOrNull() != null) {
            results = new BatchResults(run.planOrNull());
            resultTabs = new ResultTabs(tabs, results, this::open);
            resultTabs.select();
            progress.showControllers(run.planOrNull().controllerTypes());
        }
        if (results != null) {
            int before = results.size();
            for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
                results.add(row);
            }
            saved = saved && results.size() == before;
            resultTabs.update(before, run.cells());
            progress.show(run.completion(), run.progress().isActive());
        }
    }

    /** Opens a run in the window. */
    private void open(int index) {
        if (results.value(index, "simulated_s").isEmpty()) {
            showProblem(Messages.get("batch.broken", results.value(index, "failure")));
            return;
        }
        BatchResults shown = results;
        BackgroundTasks.run(
                () -> controller.callWithJars(() -> RunScenario.create(
                        shown.plan(),
                        index,
                        shown.value(index, "outcome"),
                        Double.parseDouble(shown.value(index, "simulated_s")))),
                opened -> openRun(named(opened, index)),
                this::showFailure);
    }

    /** Returns the scenario of a run, with its name in the language of the window. */
    static Scenario named(Scenario run, int index) {
        return run.withName(Messages.get("batch.run", Integer.toString(index)));
    }

    private void openRun(Scenario opened) {
        setVisible(false);
        reopen.setEnabled(true);
        actions.openRun(opened, controller.jars());
    }

    private void reopen() {
        source.reopen().run();
    }

    private void savePlan() {
        checkedPlan().ifPresent(plan -> actions.choosePlanFile(source)
                .ifPresent(file -> write(file, () -> plan.save(file), () -> {})));
    }

    /** Saves the results, after the batch has been stopped if it is still being made; {@code then} runs afterwards. */
    private void saveResults(Runnable then) {
        BatchRun made = run;
        actions.chooseResultsFolder(source).ifPresent(folder -> {
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
        BackgroundTasks.runBeforeExit(
                work,
                () -> {
                    endWriting(written);
                    progress.showStatus(() -> Messages.get("saved", String.valueOf(target.getFileName())));
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

    private void showFailure(Throwable failure) {
        showProblem(ErrorMessages.describe(failure));
    }

    private void showProblem(String sentence) {
        actions.showProblem(this, sentence);
    }

    /** Runs an action that would lose unsaved results, after asking whether to save them. */
    void runIfResultsHandled(Runnable action) {
        if (saved) {
            action.run();
            return;
        }
        String question = Messages.get(running ? "batch.loss.running" : "batch.loss");
        int answer =
                Dialogs.ask(this, getTitle(), question, "batch.saveResults", "batch.loss.discard", "unsaved.cancel");
        if (answer == 0) {
            saveResults(action);
        } else if (answer == 1) {
            action.run();
        }
    }

    private void close() {
        runIfResultsHandled(this::dispose);
    }

    private void discardRun() {
        if (run != null) {
            delete(run);
        }
        if (resultTabs != null) {
            resultTabs.remove();
        }
        results = null;
        resultTabs = null;
        progress.showControllers(List.of());
    }

    private static void delete(BatchRun ended) {
        BackgroundTasks.runBeforeExit(ended::delete, () -> {}, failure -> {});
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
