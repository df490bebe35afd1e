package faultline.gui.window;

import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.engine.session.SessionView;
import faultline.gui.dialog.ProgressDialogs;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.RunNavigator;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;

/** Polls the run and shows its newest state in the window. Event dispatch thread only. */
final class RunPoller implements WorkspaceListener {

    private final Workspace workspace;
    private final RunNavigator navigator;
    private final ComparisonController comparison;
    private final MainPanel mainPanel;
    private final ProgressDialogs progressDialogs;
    private final ReplayNotifier replayNotifier;
    private final EndNotifier endNotifier;
    private final List<BiConsumer<SessionFrame, SessionStatus>> listeners = new ArrayList<>();
    private final PollTimer timer = new PollTimer(this::poll);
    /** The ids of the sensors in the last frame. */
    private List<String> sensors = List.of();
    /** The status at the last poll; null before the first. */
    private SessionStatus polledStatus;

    RunPoller(
            Workspace workspace,
            RunNavigator navigator,
            ComparisonController comparison,
            MainPanel mainPanel,
            ProgressDialogs progressDialogs) {
        this.workspace = workspace;
        this.navigator = navigator;
        this.comparison = comparison;
        this.mainPanel = mainPanel;
        this.progressDialogs = progressDialogs;
        replayNotifier = new ReplayNotifier(navigator, mainPanel.statusBar()::showNote);
        endNotifier = new EndNotifier(mainPanel.statusBar()::showNote);
        mainPanel.statusBar().setNoteListener(this::wake);
        workspace.addListener(this);
        // A screen reader chooses without an event of the mouse or the keyboard.
        mainPanel.addChoiceListener(this::wake);
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

    /** Polls from now on, until nothing has happened for a second. */
    void wake() {
        timer.wake();
    }

    /** Returns whether nothing has happened for a second, so that nothing is polled. */
    boolean isResting() {
        return timer.isResting();
    }

    @Override
    public void sessionStarted() {
        mainPanel.statusBar().reset();
        replayNotifier.reset();
        workspace.session().ifPresent(session -> session.setPausedChangeListener(timer::signal));
        wake();
    }

    @Override
    public void pauseRequested() {
        mainPanel.statusBar().pauseRequested();
    }

    @Override
    public void taskFinished() {
        wake();
    }

    @Override
    public void comparisonChanged() {
        wake();
    }

    /** Shows the newest state of the run, and returns whether it has changed or may change soon without the user. */
    private boolean poll() {
        SessionFrame before = mainPanel.shownFrame();
        workspace.task().ifPresentOrElse(progressDialogs::update, progressDialogs::clear);
        SessionStatus status = workspace.session().map(this::show).orElse(null);
        boolean changed = !Objects.equals(status, polledStatus) || mainPanel.shownFrame() != before;
        polledStatus = status;
        boolean running = status != null && status.running();
        return changed
                || workspace.task().isPresent()
                || comparison.pending().isPresent()
                || running
                || mainPanel.statusBar().isNoteShown();
    }

    /** Shows the newest frame of a session, and returns its status. */
    private SessionStatus show(SessionView session) {
        // Status before frame: if the status says paused, the frame is the one at which the run is paused.
        SessionStatus status = session.status();
        SessionFrame frame = session.frame();
        List<String> present = frame.snapshot().robot().sensorIds();
        if (!present.equals(sensors)) {
            sensors = present;
            mainPanel.renameSensors(id -> workspace.presentId(id, present));
        }
        workspace.takeRenames().ifPresent(mainPanel::renameObstacles);
        mainPanel.setFrame(frame, status, session.setup().timeline());
        replayNotifier.update(frame.frame());
        workspace.scenario().ifPresent(open -> {
            mainPanel.setRun(frame, status, open, navigator.furthestTick());
            endNotifier.update(frame.snapshot().tick(), frame.dt(), open.setup());
        });
        listeners.forEach(listener -> listener.accept(frame, status));
        return status;
    }
}
