package faultline.gui.window;

import faultline.engine.Frame;
import faultline.engine.Session;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.Theme;
import faultline.world.Command;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BoundedRangeModel;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** All of the window below its menu bar: tool bar, canvas, control panel and status bar. Needs no display. */
final class WorkArea extends JPanel {

    private final SimulationCanvas canvas;
    private final ControlPanel panel;
    private final StatusBar status = new StatusBar();
    private final JSplitPane split;
    private transient Optional<Frame> shown = Optional.empty();

    /**
     * Shows nothing yet.
     *
     * @param canvas the canvas
     * @param commands where the control panel's changes go
     * @param actions of the window
     * @param speed positions of {@link SpeedScale}
     */
    WorkArea(SimulationCanvas canvas, Consumer<Command> commands, UiActions actions, BoundedRangeModel speed) {
        super(new BorderLayout());
        this.canvas = canvas;
        panel = new ControlPanel(commands, actions.get("path"));
        split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, canvas, panel);
        split.setResizeWeight(1);
        split.setContinuousLayout(true);
        add(new ToolBar(actions, speed), BorderLayout.NORTH);
        add(split, BorderLayout.CENTER);
        add(status, BorderLayout.SOUTH);
        canvas.addCursorListener(status::showCursor);
        canvas.addCameraListener(camera -> status.showScale(camera.scale()));
        canvas.setPalette(Theme.current().palette());
    }

    /** Shows how the run is; the picture is painted anew only where there is a new one. */
    void show(Frame frame, Session.Status now) {
        assert EventQueue.isDispatchThread();
        if (shown.isEmpty() || shown.get() != frame) {
            shown = Optional.of(frame);
            canvas.show(frame);
        }
        panel.show(frame.world());
        status.show(frame, now);
    }

    ControlPanel panel() {
        return panel;
    }

    StatusBar status() {
        return status;
    }

    JSplitPane split() {
        return split;
    }
}
