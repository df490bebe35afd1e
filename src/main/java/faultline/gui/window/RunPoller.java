package faultline.gui.window;

import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.gui.dialog.ProgressDialogs;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;

/** Polls the run and shows its newest state in the window. To be used on the event dispatch thread only. */
final class RunPoller implements WorkspaceListener {

    private final Workspace workspace;
    private final RunController runController;
    private final MainPanel mainPanel;
    private final ProgressDialogs progressDialogs;
    private final ReplayNotifier replayNotifier;
    private final List<BiConsumer<SessionFrame, SessionStatus>> listeners = new ArrayList<>();
    private final PollTimer timer = new PollTimer(this::poll);
    /** The status at the last poll; null before the first. */
    private SessionStatus polledStatus;

    RunPoller(Workspace workspace, RunController runController, MainPanel mainPanel, ProgressDialogs progressDialogs) {
        this.workspace = workspace;
        this.runController = runController;
        this.mainPanel = mainPanel;
        this.progressDialogs = progressDialogs;
        replayNotifier = new ReplayNotifier(runController.navigator(), mainPanel.statusBar()::showNote);
        workspace.addListener(this);
    }

    /** Adds a listener that receives the newest frame and status at each poll while a scenario is open. */
    void addListener(BiConsumer<SessionFrame, SessionStatus> listener) {
        listeners.add(listener);
    }

    void start() {
        timer.start();
    }

    void stop() {
        timer.stop();
    }

    @Override
    public void sessionStarted() {
        mainPanel.statusBar().reset();
        replayNotifier.reset();
    }

    /** Shows the newest state of the run, and returns whether it has changed or may change soon without the user. */
    private boolean poll() {
        SessionFrame before = mainPanel.shownFrame();
        workspace.task().ifPresentOrElse(progressDialogs::update, progressDialogs::clear);
        // Status before frame: if the status says paused, the frame is the one at which the run is paused.
        runController.status().ifPresent(status -> runController.frame().ifPresent(frame -> show(frame, status)));
        SessionStatus status = runController.status().orElse(null);
        boolean changed = !Objects.equals(status, polledStatus) || mainPanel.shownFrame() != before;
        polledStatus = status;
        return changed
                || status == null
                || status.running()
                || workspace.task().isPresent()
                || mainPanel.statusBar().isNoteShown() && status.failure().isEmpty();
    }

    private void show(SessionFrame frame, SessionStatus status) {
        mainPanel.setFrame(frame, status);
        replayNotifier.update(frame.frame());
        workspace
                .scenario()
                .ifPresent(open -> mainPanel.setRun(
                        frame, status, open, runController.navigator().furthestTick()));
        listeners.forEach(listener -> listener.accept(frame, status));
    }
}
