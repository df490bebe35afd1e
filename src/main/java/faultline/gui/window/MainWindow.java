package faultline.gui.window;

import faultline.external.ControllerChoice;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.ComparisonActions;
import faultline.gui.action.EditActions;
import faultline.gui.action.Notes;
import faultline.gui.action.ObstacleActions;
import faultline.gui.action.PreferenceActions;
import faultline.gui.action.RunActions;
import faultline.gui.action.SensorActions;
import faultline.gui.action.SpeedScale;
import faultline.gui.action.ThemeAction;
import faultline.gui.action.ViewActions;
import faultline.gui.bar.StatusBar;
import faultline.gui.batch.BatchActions;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.dialog.AppIcon;
import faultline.gui.dialog.ControllerActions;
import faultline.gui.dialog.Dialogs;
import faultline.gui.dialog.ExampleActions;
import faultline.gui.dialog.FileController;
import faultline.gui.dialog.NumberDialog;
import faultline.gui.dialog.PreferencesDialog;
import faultline.gui.dialog.ProgressDialogs;
import faultline.gui.dialog.TextDropHandler;
import faultline.gui.document.Autosave;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.FileWatch;
import faultline.gui.document.RecoveryPrompt;
import faultline.gui.document.RecoveryStore;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.export.ExportController;
import faultline.gui.properties.ScenarioActions;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.timeline.TimelineActions;
import faultline.gui.timeline.TimelineEditor;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenarios;
import java.awt.EventQueue;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import javax.swing.BoundedRangeModel;
import javax.swing.DefaultBoundedRangeModel;
import javax.swing.JFrame;
import javax.swing.WindowConstants;

/** The main window: creates the parts of the window and connects them. */
public final class MainWindow extends JFrame {

    private static final int SIMULATION_MENU = 3;

    private final transient Workspace workspace = new Workspace();
    private final transient RunController runController = new RunController(workspace);
    private final transient ComparisonController comparisonController =
            new ComparisonController(workspace, runController.navigator());
    private final StatusBar statusBar = new StatusBar();
    private final transient Notes notes =
            new Notes(statusBar::showNote, statusBar::keepNote, statusBar::showLine, statusBar::removeNote);
    private final transient FileNotifier fileNotifier = new FileNotifier(workspace, statusBar);
    private final transient ControllerActions controllerActions;
    private final transient CommandSender commandSender = new CommandSender(runController::send);
    private final transient UndoController undoController = new UndoController(commandSender, this::updateEditActions);
    private final transient ScenarioEditor scenarioEditor = new ScenarioEditor(runController, undoController);
    private final transient EditActions editActions = new EditActions(undoController, this::undoTyping);
    private final transient ActionRegistry actionRegistry = new ActionRegistry();
    private final transient Dialogs dialogs = new Dialogs(this);
    private final transient FileController fileController =
            new FileController(this, workspace, this::commitPendingEdit);
    private final transient ExampleActions exampleActions;
    private final transient BatchActions batchActions;
    private final SimulationCanvas canvas = new SimulationCanvas(commandSender);
    private final transient ExportController exportController = new ExportController(
            this, workspace, canvas, fileController::chooseExportFile, fileNotifier::fileSaved, notes);
    private final transient SensorActions sensorActions = new SensorActions(
            workspace, commandSender, new SensorEditor(workspace, scenarioEditor, notes::show), canvas.tools());
    private final transient RunActions runActions;
    private final transient ObstacleActions obstacleActions;
    private final transient WindowPreferences preferences;
    private final transient ThemeAction themeAction;
    private final transient WindowParts parts;
    private final MainPanel mainPanel;
    private final transient WindowBounds windowBounds;
    private final transient WindowCloser closer;
    private final TourCard tour;
    private final transient ComparisonActions comparisonActions;
    private final transient TimelineActions timelineActions;
    private final transient FileWatch fileWatch;
    private final transient RunPoller runPoller;
    /** Null until recovery is enabled. */
    private transient Autosave autosave;

    /** Creates a window without a scenario, not yet visible. */
    public MainWindow(WindowPreferences preferences) {
        assert EventQueue.isDispatchThread();
        this.preferences = preferences;
        controllerActions = new ControllerActions(
                this, workspace, runController, comparisonController, notes, preferences.recentCommands());
        exampleActions = new ExampleActions(this, fileController, preferences, notes::show);
        batchActions = new BatchActions(this, fileController, controllerActions, notes::show);
        themeAction = new ThemeAction(canvas, preferences);
        BoundedRangeModel speed =
                new DefaultBoundedRangeModel(SpeedScale.REAL_TIME_POSITION, 0, 0, SpeedScale.UNLIMITED);
        runActions = new RunActions(runController, speed, now -> NumberDialog.TIME.ask(this, now));
        parts = new WindowParts(preferences);
        obstacleActions = createObstacleActions();
        addActions();
        mainPanel = new MainPanel(
                canvas, statusBar, createEditors(), actionRegistry, speed, runController.navigator()::seek);
        comparisonActions = new ComparisonActions(comparisonController, mainPanel::setReferenceRun, notes);
        connectExport();
        timelineActions = addTimelineActions();
        comparisonActions.addTo(actionRegistry, fileController::chooseReferenceRunFile);
        installMenuBar();
        setContentPane(mainPanel);
        tour = mainPanel.addTour(this, getJMenuBar().getMenu(SIMULATION_MENU));
        setIconImages(AppIcon.images());
        setTransferHandler(fileController.createDropHandler(() -> {}, notes::show));
        TextDropHandler.install(mainPanel, getTransferHandler());
        setTitle(fileController.documentTitle());
        windowBounds = new WindowBounds(this, mainPanel, preferences);
        windowBounds.restore();
        closer = new WindowCloser(this, windowBounds, exportController, batchActions, fileController);
        parts.install(this, mainPanel);
        installCloseHandler();
        installViewListeners();
        new SpaceKeyDispatcher(this, runController::toggleRunning).install(this);
        fileWatch = createFileWatch();
        connectUndo();
        addWorkspaceListeners();
        runPoller = createRunPoller();
        runPoller.start();
    }

    private void installMenuBar() {
        setJMenuBar(Menus.createMenuBar(actionRegistry));
        getJMenuBar().getMenu(0).insert(new RecentMenu(preferences.recentFiles(), this::openRecent), 2);
    }

    private ObstacleActions createObstacleActions() {
        return new ObstacleActions(
                canvas.tools(),
                commandSender,
                sensorActions,
                notes,
                now -> NumberDialog.MOTION_SPEED.ask(this, now),
                preferences);
    }

    private RunPoller createRunPoller() {
        RunPoller poller = new RunPoller(
                workspace,
                runController.navigator(),
                comparisonController,
                mainPanel,
                new ProgressDialogs(this, workspace::cancelTask));
        poller.addListener((frame, status) -> {
            undoController.runAdvanced(frame.snapshot().tick());
            comparisonActions.update(frame);
            runActions.update(status, frame.snapshot().tick());
            timelineActions.update(frame.snapshot().tick());
            obstacleActions.update();
            sensorActions.update();
        });
        return poller;
    }

    private void connectInstruments() {
        mainPanel.instruments().chart().setMenuExtension(popup -> Menus.addChartItems(popup, actionRegistry));
        mainPanel.instruments().setPrintedLines(controllerActions::takePrintedLines);
    }

    private FileWatch createFileWatch() {
        return new FileWatch(
                workspace, fileController::onFileChangedOnDisk, fileNotifier::fileBroken, fileNotifier::fileDeleted);
    }

    private void connectExport() {
        exportController.setDiscardQuestion(fileController::askToDiscardRecording);
        fileController.setLeaveQuestion(exportController::runIfRecordingHandled);
        exportController.setChart(() ->
                workspace.session().flatMap(session -> mainPanel.instruments().chartContent(session.frame())));
    }

    private TimelineActions addTimelineActions() {
        TimelineActions added = new TimelineActions(mainPanel.timeline(), runController.navigator(), notes);
        added.addTo(actionRegistry);
        workspace.addListener(added);
        return added;
    }

    private void connectUndo() {
        EditNotifier editNotifier = new EditNotifier(workspace, actionRegistry, notes);
        workspace.addListener(editNotifier);
        undoController.setForkListener(editNotifier::timelineForked);
        undoController.follow(workspace, runController);
        undoController.setUndoListener(editNotifier::editUndone);
        undoController.setEditListener(editNotifier::editMade);
        undoController.setScenarioListener(editNotifier::editChangedScenario);
    }

    private void addWorkspaceListeners() {
        workspace.addListener(new WorkspaceEvents());
        workspace.addListener(fileNotifier);
        workspace.addListener(new RecentFilesListener(workspace, preferences.recentFiles()));
        workspace.addListener(new FailureListener(
                workspace, controllerActions, dialogs, () -> openShipped(ShippedScenarios.DEFAULT)));
    }

    private MainPanel.Editors createEditors() {
        TimelineEditor timeline = new TimelineEditor(workspace, runController, undoController, notes::show);
        ObstacleEditor obstacles = new ObstacleEditor(workspace, scenarioEditor);
        return new MainPanel.Editors(commandSender, scenarioEditor, sensorActions, obstacles, timeline);
    }

    private void addActions() {
        fileController.addTo(actionRegistry, () -> closer.quit());
        exampleActions.addTo(actionRegistry, this::startTour);
        new ScenarioActions(
                        this,
                        workspace,
                        scenarioEditor,
                        fileController::runIfChangesHandled,
                        fileController::openNewWithoutAsking)
                .addTo(actionRegistry);
        editActions.addTo(actionRegistry);
        editActions.bindTo(getRootPane());
        sensorActions.addTo(actionRegistry);
        obstacleActions.addTo(actionRegistry);
        exportController.actions().forEach(actionRegistry::add);
        ViewActions.addTo(actionRegistry, canvas);
        ViewActions.addPathColours(actionRegistry, canvas, preferences);
        ViewActions.bindTo(getRootPane(), actionRegistry);
        parts.addTo(actionRegistry);
        FocusAreas.addActions(actionRegistry, step -> mainPanel.focusArea(step));
        runActions.addTo(actionRegistry);
        controllerActions.addTo(actionRegistry);
        batchActions.addTo(actionRegistry);
        dialogs.addTo(actionRegistry);
        PreferenceActions choices = new PreferenceActions(preferences, actionRegistry, this::showLanguage);
        actionRegistry.add(themeAction.action());
        PreferencesDialog.addTo(actionRegistry, this, preferences, choices, themeAction);
    }

    private void openRecent(Path file) {
        fileController.openFirst(List.of(file), notes::show);
    }

    private boolean commitPendingEdit() {
        return mainPanel.controlPanel().commitPendingEdit();
    }

    private boolean undoTyping() {
        return mainPanel.controlPanel().undoTyping();
    }

    /** Returns whether nothing has happened for a second, so that nothing is polled. */
    boolean isResting() {
        return runPoller.isResting();
    }

    private void installViewListeners() {
        connectInstruments();
        Menus.installContextMenu(
                canvas,
                actionRegistry,
                new RobotMenu(commandSender, sensorActions, this::addFault, mainPanel::addMotorFault));
        canvas.tools().setReservedIds(workspace::obstacleIds);
        commandSender.setNaming(workspace::ofViews);
        canvas.tools().listeners().addStartListener(pose -> workspace
                .scenario()
                .ifPresent(open -> scenarioEditor.moveStart(open.setup(), pose)));
    }

    private void addFault(String sensor) {
        parts.showTimeline();
        mainPanel.timeline().lanes().addFault(sensor);
    }

    private void updateEditActions() {
        editActions.update();
    }

    /** Updates the texts that no component refreshes itself to the current language. */
    private void showLanguage() {
        setTitle(fileController.documentTitle());
        editActions.update();
        comparisonActions.updateTexts();
        controllerActions.updateTexts();
    }

    private void installCloseHandler() {
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        addWindowListener(closer);
        addWindowListener(new ExposedRepaint(getRootPane()));
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                windowBounds.onWindowOpened();
                canvas.requestFocusInWindow();
            }
        });
        addWindowFocusListener(new FocusReturn(canvas));
        setFocusTraversalPolicy(new DisabledFocusPolicy(canvas));
    }

    ActionRegistry actions() {
        return actionRegistry;
    }

    /** Ends the run and the exports with the window. */
    @Override
    public void dispose() {
        exportController.exports().cancel();
        runPoller.stop();
        fileWatch.close();
        controllerActions.close();
        themeAction.close();
        workspace.close();
        super.dispose();
    }

    /** Opens a scenario file asynchronously. */
    public void open(Path file) {
        fileController.openWithoutAsking(file);
    }

    /**
     * Opens a scenario file asynchronously, given what reads it, with a controller, and that of a ghost beside it, null
     * for none.
     */
    public void open(Path file, Callable<Scenario> reader, ControllerChoice controller, ControllerChoice ghostOrNull) {
        controllerActions.select(controller, ghostOrNull);
        open(file, reader);
    }

    /** Opens a scenario file asynchronously, given what reads it. */
    public void open(Path file, Callable<Scenario> reader) {
        fileController.openWithoutAsking(file, reader);
    }

    /** Opens a shipped scenario asynchronously, given the name of its file. */
    public void openShipped(String name) {
        fileController.openShippedWithoutAsking(name);
    }

    /** Calls a listener once, on the event dispatch thread, after the first frame has been painted. */
    public void onFirstPaint(Runnable listener) {
        canvas.runAfterNextPaint(listener);
    }

    /** Shows the gallery of shipped scenarios in front of the window until the user closes it or drops a file on it. */
    public void showExamples() {
        exampleActions.showGallery(this::startTour);
    }

    private void startTour() {
        parts.showForTour();
        tour.start();
    }

    /**
     * Starts to store unsaved edits where a crash cannot lose them, and offers those of earlier crashes asynchronously.
     * If there are none, {@code otherwise} is called.
     */
    public void enableRecovery(RecoveryStore recovery, Runnable otherwise) {
        autosave = new Autosave(
                workspace, recovery, failure -> fileNotifier.autosaveFailed(failure, () -> autosave.isFailing()));
        RecoveryPrompt.offerRecovery(
                recovery, autosave, fileController::offerRecovery, fileNotifier::editsLeft, otherwise);
    }

    /** Shows events of the workspace. */
    private final class WorkspaceEvents implements WorkspaceListener {

        @Override
        public void scenarioOpened() {
            mainPanel.startScenario();
            batchActions.scenarioOpened();
        }

        @Override
        public void sessionStarted() {
            mainPanel.instruments().startRun();
            mainPanel.controlPanel().setChosenController(controllerActions.chosenText());
        }

        @Override
        public void titleChanged() {
            setTitle(fileController.documentTitle());
        }
    }
}
