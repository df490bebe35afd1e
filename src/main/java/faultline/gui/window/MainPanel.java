package faultline.gui.window;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.engine.session.SessionStatus;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.SensorActions;
import faultline.gui.action.SpeedScale;
import faultline.gui.bar.ObstaclePalette;
import faultline.gui.bar.StatusBar;
import faultline.gui.bar.ToolBar;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleEditor;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.motor.MotorFaultDialog;
import faultline.gui.motor.MotorPanel;
import faultline.gui.panel.ControlPanel;
import faultline.gui.properties.ObstaclePanel;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineEditor;
import faultline.gui.timeline.TimelinePanel;
import faultline.paint.scene.ReferenceOverlay;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.world.Collision;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.function.LongConsumer;
import java.util.function.UnaryOperator;
import javax.swing.BoundedRangeModel;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JPanel;

/**
 * The contents of the window below its menu bar: tool bar, canvas, instruments, control panel and status bar. Needs no
 * display.
 */
final class MainPanel extends JPanel {

    private final SimulationCanvas canvas;
    private final ControlPanel controlPanel;
    private final StatusBar statusBar;
    private final InstrumentDock instruments;
    private final TimelinePanel timeline;
    private final ObstaclePanel obstacles;
    private final MotorPanel motors;
    private final transient MotorFaultDialog motorFaultDialog;
    private final VerdictBanner banner;
    private final transient CanvasOverlays overlays;
    private final transient WindowDividers dividers;
    private final transient FocusAreas focusAreas;
    /** Null before the first frame. */
    private transient SessionFrame shownFrame;

    /**
     * What carries out the user's edits of the run, of the scenario's settings, of its sensors, of the ids of its
     * obstacles and of its time line.
     */
    record Editors(
            CommandSender sender,
            ScenarioEditor scenario,
            SensorActions sensors,
            ObstacleEditor obstacles,
            TimelineEditor timeline) {}

    /**
     * Creates a panel without a scenario; {@code speed} holds positions of {@link SpeedScale}, and {@code jump}
     * receives the tick of an event to go to.
     */
    MainPanel(
            SimulationCanvas canvas,
            StatusBar statusBar,
            Editors editors,
            ActionRegistry actions,
            BoundedRangeModel speed,
            LongConsumer jump) {
        super(new BorderLayout());
        this.canvas = canvas;
        this.statusBar = statusBar;
        controlPanel = new ControlPanel(
                editors.sender(),
                editors.scenario(),
                new ControlPanel.SensorEdits(
                        editors.sensors()::add, editors.sensors()::remove, editors.sensors()::rename),
                new ControlPanel.PanelActions(
                        actions.get("path"), actions.get("chooseController"), actions.get("scenarioController")));
        motorFaultDialog = new MotorFaultDialog(this, editors.sender());
        motors = new MotorPanel(editors.sender(), this::addMotorFault);
        controlPanel.addRobotSection("motors.title", motors);
        obstacles = new ObstaclePanel(editors.sender(), editors.obstacles(), canvas.tools());
        controlPanel.addTab("panel.obstacles", obstacles);
        instruments = new InstrumentDock(jump);
        timeline = new TimelinePanel(jump, canvas::setFrame, editors.timeline());
        focusAreas = new FocusAreas(List.of(canvas, timeline.bar(), timeline.lanes(), instruments, controlPanel));
        banner = new VerdictBanner(jump);
        overlays = new CanvasOverlays(canvas, banner);
        dividers = new WindowDividers(this, canvas, timeline, instruments, controlPanel);
        add(new ToolBar(actions, speed), BorderLayout.NORTH);
        add(new ObstaclePalette(actions), BorderLayout.LINE_START);
        add(dividers.panes(), BorderLayout.CENTER);
        add(statusBar, BorderLayout.SOUTH);
        addCanvasListeners();
        canvas.setPalette(Theme.current().palette());
        RefreshSteps.add(this, self -> self.dividers.scaleToText());
    }

    private void addCanvasListeners() {
        canvas.tools().listeners().addNoteListener(statusBar::showNote);
        canvas.tools()
                .addSensorListener(sensor ->
                        sensor.ifPresentOrElse(controlPanel::selectSensor, controlPanel::clearSensorSelection));
        controlPanel.addSelectionListener(canvas.tools()::selectSensor);
        canvas.addCursorListener(point -> statusBar.showCursor(point.orElse(null)));
        canvas.addCameraListener(camera -> statusBar.showScale(camera.scale()));
    }

    /** Adds a listener for changes of the selected obstacles, and of whether their tab shows, which need a frame. */
    void addChoiceListener(Runnable listener) {
        canvas.tools().addSelectionListener(ids -> listener.run());
        obstacles.addHierarchyListener(event -> listener.run());
    }

    /** Gives what is selected the ids that sensors have in the next frame, as returned for the present ones. */
    void renameSensors(UnaryOperator<String> presentId) {
        // The canvas selects its sensor in the control panel, too, which must have the new id before.
        controlPanel.renameSensors(presentId);
        canvas.tools().renameSensors(presentId);
        instruments.renameSensors(presentId);
        timeline.renameSensors(presentId);
    }

    /** Gives what is selected the ids that obstacles have in the next frame, as returned for the present ones. */
    void renameObstacles(UnaryOperator<String> nextId) {
        canvas.tools().renameObstacles(nextId);
    }

    /** Shows a frame of a run with a timeline; the canvas is repainted only if the frame is new. */
    void setFrame(SessionFrame frame, SessionStatus now, List<TimedCommand> runTimeline) {
        assert EventQueue.isDispatchThread();
        // The canvas may select a sensor that is new in this frame, so the control panel must have it before.
        controlPanel.setSnapshot(frame.snapshot(), runTimeline);
        motors.setSnapshot(frame.snapshot(), runTimeline);
        if (!timeline.bar().isAdjusting() && shownFrame != frame) {
            shownFrame = frame;
            canvas.setFrame(frame.frame());
            overlays.update();
        }
        instruments.setItems(timeline.items());
        if (instruments.isVisible()) {
            instruments.setFrame(frame);
        }
        if (obstacles.isShowing()) {
            obstacles.setObstacles(frame.snapshot().obstacles());
        }
        statusBar.setFrame(frame, now);
    }

    /** Asks for a fault of the motors of a side, and adds it to the run. */
    void addMotorFault(MotorSide side) {
        motorFaultDialog.addFault(side);
    }

    /** Returns the frame that was shown last; null before the first. */
    SessionFrame shownFrame() {
        return shownFrame;
    }

    /** Prepares for another scenario: notes, selections and drags of the previous one are removed. */
    void startScenario() {
        instruments.startScenario();
        timeline.startScenario();
        canvas.tools().startScenario();
        controlPanel.startScenario();
        statusBar.clearNotes();
    }

    /** Shows the progress of the run of a scenario, whose furthest tick is given, and at its end the verdict. */
    void setRun(SessionFrame frame, SessionStatus now, Scenario edited, long furthestTick) {
        // A restart with ticks of another length may have been cancelled; the views count those of the run.
        SimulationSetup setup = edited.setup().withTick(frame.dt());
        Scenario scenario = edited.withSetup(setup);
        timeline.setFrame(frame, Math.max(furthestTick, setup.ticks()), setup.ticks());
        controlPanel.setRun(frame, now, scenario);
        RunVerdict.of(frame, now, scenario)
                .ifPresentOrElse(verdict -> banner.setVerdict(verdict, setup.dt()), banner::clearVerdict);
        // The banner names the first collision, too, unless it is about a failure.
        canvas.setCollisionReported(!banner.isVisible() || now.failure().isPresent());
    }

    /** Shows a reference run and where it first differs from the run, each null for none. */
    void setReferenceRun(ReferenceOverlay overlay, RunEvent.Diverged divergence) {
        canvas.setReferenceOverlay(overlay);
        timeline.bar().setDivergence(divergence);
        instruments.setReference(overlay == null ? null : overlay.run());
        instruments.setDivergence(divergence);
        RunEvent.GhostCollided contact = ghostContact(overlay);
        timeline.setGhostContact(contact);
        instruments.setGhostContact(contact);
    }

    /** Returns the contact of a reference run, null for none, at the tick of the run in the frame. */
    private RunEvent.GhostCollided ghostContact(ReferenceOverlay overlay) {
        if (overlay == null || overlay.run().collision().isEmpty()) {
            return null;
        }
        Collision collision = overlay.run().collision().get();
        SimulationSetup setup = overlay.run().setup();
        double dt = shownFrame == null ? setup.dt() : shownFrame.dt();
        return new RunEvent.GhostCollided(SimulationSetup.tickAt(setup.timeOf(collision.tick()), dt), collision);
    }

    /**
     * Adds the tour, whose last step is about a menu, to the canvas, not yet visible, and the marker of its controls to
     * a frame.
     */
    TourCard addTour(JFrame frame, JMenu ghostMenu) {
        TourMarker marker = new TourMarker();
        frame.setGlassPane(marker);
        TourCard card = new TourCard(
                List.of(
                        new TourCard.TourStep("break", controlPanel.sensorDetails()),
                        new TourCard.TourStep("health", controlPanel.runPanel()),
                        new TourCard.TourStep("timeline", timeline.lanes()),
                        new TourCard.TourStep("ghost", ghostMenu)),
                marker::setTarget);
        overlays.addCard(card);
        return card;
    }

    TimelinePanel timeline() {
        return timeline;
    }

    InstrumentDock instruments() {
        return instruments;
    }

    /**
     * Moves the focus to the next area, or to the previous one: canvas, time slider, lanes, instruments, control panel.
     */
    void focusArea(int step) {
        focusAreas.move(step);
    }

    WindowDividers dividers() {
        return dividers;
    }

    ControlPanel controlPanel() {
        return controlPanel;
    }

    StatusBar statusBar() {
        return statusBar;
    }
}
