package faultline.gui.window;

import faultline.engine.Frame;
import faultline.engine.Session;
import faultline.engine.record.RunEvent;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.edit.Editor;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.instrument.PlacedSplit;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.Ghost;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.BoundedRangeModel;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** All of the window below its menu bar: tool bar, canvas, instruments, control panel and status bar. Needs no display. */
final class WorkArea extends JPanel {

    /** What canvas and instruments need at the normal size of texts, pixels. */
    private static final int LEAST_STAGE = 300;
    /** What the canvas and its time line keep where the window is low, pixels. */
    private static final int LEAST_HEIGHT = 220;
    /** The share of the height that the instruments may have at first. */
    private static final double MOST_DOCK = 0.45;

    private final SimulationCanvas canvas;
    private final ControlPanel panel;
    private final StatusBar status = new StatusBar();
    private final InstrumentDock instruments;
    private final TimeBar time;
    private final PlacedSplit dockSplit;
    private final PlacedSplit split;
    private int dockHeight;
    private transient Optional<Frame> shown = Optional.empty();

    /**
     * Shows nothing yet.
     *
     * @param canvas the canvas
     * @param editor where the control panel's changes go
     * @param actions of the window
     * @param speed positions of {@link SpeedScale}
     * @param jump given the tick of an event that the user wants to go to
     */
    WorkArea(SimulationCanvas canvas, Editor editor, UiActions actions, BoundedRangeModel speed, LongConsumer jump) {
        super(new BorderLayout());
        this.canvas = canvas;
        panel = new ControlPanel(editor, actions.get("path"));
        instruments = new InstrumentDock(jump);
        dockHeight = instruments.getPreferredSize().height;
        time = new TimeBar(jump, canvas::show);
        JPanel stage = new JPanel(new BorderLayout());
        stage.add(canvas, BorderLayout.CENTER);
        stage.add(time, BorderLayout.SOUTH);
        stage.setMinimumSize(new Dimension(0, LEAST_HEIGHT));
        dockSplit = new PlacedSplit(JSplitPane.VERTICAL_SPLIT, stage, instruments, 1);
        setDockHeight(dockHeight);
        dockSplit.setMinimumSize(new Dimension(TextSize.scaled(LEAST_STAGE), 0));
        split = new PlacedSplit(JSplitPane.HORIZONTAL_SPLIT, dockSplit, panel, 1);
        setPanelWidth(panel.usualWidth());
        add(new ToolBar(actions, speed), BorderLayout.NORTH);
        add(new ObstaclePalette(actions), BorderLayout.LINE_START);
        add(split, BorderLayout.CENTER);
        add(status, BorderLayout.SOUTH);
        canvas.tools().addNoteListener(status::showNote);
        canvas.tools().addSensorListener(panel::select);
        panel.addSelectionListener(canvas.tools()::selectSensor);
        canvas.addCursorListener(status::showCursor);
        canvas.addCameraListener(camera -> status.showScale(camera.scale()));
        canvas.setPalette(Theme.current().palette());
    }

    /** Shows how the run is; the picture is painted anew only where there is a new one. */
    void show(Frame frame, Session.Status now) {
        assert EventQueue.isDispatchThread();
        if (!time.isHeld() && (shown.isEmpty() || shown.get() != frame)) {
            shown = Optional.of(frame);
            canvas.show(frame);
        }
        if (instruments.isVisible()) {
            instruments.show(frame);
        }
        panel.show(frame.world());
        status.show(frame, now);
    }

    /** Shows, from now on, an earlier run beside this one, and where the two first differ. */
    void haunt(Optional<Ghost> ghost, Optional<RunEvent.Diverged> divergence) {
        canvas.setGhost(ghost);
        time.mark(divergence);
        instruments.mark(divergence);
    }

    TimeBar time() {
        return time;
    }

    InstrumentDock instruments() {
        return instruments;
    }

    /** Makes the control panel so wide, pixels, as far as the canvas and the instruments can spare it. */
    void setPanelWidth(int width) {
        split.place(size -> size - Math.min(width, size - TextSize.scaled(LEAST_STAGE)));
    }

    /** How high the instruments are, or were before they were hidden, pixels. */
    int dockHeight() {
        return instruments.isVisible() && instruments.getHeight() > 0 ? instruments.getHeight() : dockHeight;
    }

    /** Makes the instruments so high, pixels. */
    void setDockHeight(int height) {
        dockHeight = height;
        dockSplit.place(size -> size - Math.min(height, (int) (MOST_DOCK * size)));
    }

    /** Shows or hides the instruments. */
    void setDockShown(boolean shown) {
        dockHeight = dockHeight();
        instruments.setVisible(shown);
        setDockHeight(dockHeight);
    }

    ControlPanel panel() {
        return panel;
    }

    StatusBar status() {
        return status;
    }
}
