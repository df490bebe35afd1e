package faultline.gui.window;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.instrument.InstrumentDock;
import faultline.gui.instrument.PositionedSplitPane;
import faultline.gui.panel.ControlPanel;
import faultline.gui.theme.TextSize;
import faultline.gui.timeline.TimelinePanel;
import java.awt.Dimension;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JSplitPane;

/**
 * The dividers between the canvas, the time line below it, the instruments and the control panel. Each has a default
 * place, and one for the size that the user has chosen, which grows with the text.
 */
final class WindowDividers {

    /** Minimum width of the canvas, pixels. */
    private static final int MIN_STAGE_WIDTH = 300;
    /**
     * Minimum width of the instruments, in which their tabs and controls have room, at the normal text size, pixels.
     */
    private static final int MIN_DOCK_WIDTH = 272;
    /** Minimum height of the canvas with its time bar, pixels. */
    private static final int MIN_STAGE_HEIGHT = 220;
    /** The height of lanes with as many rows as there is room for. */
    private static final int BY_ROOM = 0;
    /** Minimum height of the canvas above lanes that the user makes higher, pixels. */
    private static final int MIN_CANVAS_HEIGHT = 100;
    /** Minimum height of a chart in which the lines can be distinguished, pixels. */
    private static final int MIN_CHART_HEIGHT = 86;
    /** Height of the tabs and controls above a chart at the normal text size, pixels. */
    private static final int CHART_BARS_HEIGHT = 74;

    private final JComponent contents;
    private final TimelinePanel timeline;
    private final InstrumentDock instruments;
    private final ControlPanel controlPanel;
    /** The canvas and the time line. */
    private final PositionedSplitPane stage;
    /** The stage and the instruments. */
    private final PositionedSplitPane dockSplit;
    /** All that and the control panel. */
    private final PositionedSplitPane panelSplit;
    /** The height of the lanes that the user has chosen, pixels, or {@link #BY_ROOM}. */
    private int lanesHeight = BY_ROOM;

    private int dockHeight;
    private int panelWidth;
    /** The text size that the dividers are placed for. */
    private int textPercent = TextSize.current().percent();

    /**
     * Creates the dividers at their default places.
     *
     * @param contents the contents of the window, to which {@link #panes()} will be added
     */
    WindowDividers(
            JComponent contents,
            SimulationCanvas canvas,
            TimelinePanel timeline,
            InstrumentDock instruments,
            ControlPanel controlPanel) {
        this.contents = contents;
        this.timeline = timeline;
        this.instruments = instruments;
        this.controlPanel = controlPanel;
        canvas.setMinimumSize(new Dimension(0, MIN_CANVAS_HEIGHT));
        stage = new PositionedSplitPane("divider.lanes", JSplitPane.VERTICAL_SPLIT, canvas, timeline, 1);
        placeLanes();
        timeline.addLanesListener(this::keepLanesHeight);
        stage.setMinimumSize(new Dimension(0, MIN_STAGE_HEIGHT));
        dockSplit = new PositionedSplitPane("divider.instruments", JSplitPane.VERTICAL_SPLIT, stage, instruments, 1);
        setDockHeight(instruments.getPreferredSize().height);
        panelSplit = new PositionedSplitPane(
                "divider.controlPanel", JSplitPane.HORIZONTAL_SPLIT, dockSplit, controlPanel, 1);
        setPanelWidth(controlPanel.defaultWidth());
    }

    /** Returns the pane with all that the dividers separate. */
    JComponent panes() {
        return panelSplit;
    }

    /** Changes the sizes between the dividers with the text size. */
    void scaleToText() {
        dockSplit.setMinimumSize(new Dimension(TextSize.scaled(MIN_STAGE_WIDTH), 0));
        double growth = TextSize.current().percent() / (double) textPercent;
        textPercent = TextSize.current().percent();
        if (growth != 1) {
            setLanesHeight((int) Math.round(growth * currentLanesHeight()));
            setPanelWidth((int) Math.round(growth * panelWidth()));
            setDockHeight((int) Math.round(growth * dockHeight()));
        }
    }

    /** Returns the width of the control panel that the user has chosen, pixels. */
    int panelWidth() {
        return controlPanel.isVisible() && panelSplit.isMoved() ? controlPanel.getWidth() : panelWidth;
    }

    /** Sets the width of the control panel in pixels; the canvas keeps at least half of the window. */
    void setPanelWidth(int width) {
        panelWidth = width;
        panelSplit.place(
                size -> size - Math.min(width, size - Math.max(minStageWidth(), (contents.getWidth() + 1) / 2)));
    }

    private int minStageWidth() {
        return instruments.isVisible() ? Math.max(MIN_STAGE_WIDTH, TextSize.scaled(MIN_DOCK_WIDTH)) : MIN_STAGE_WIDTH;
    }

    /** Shows or hides the control panel. */
    void setPanelShown(boolean shown) {
        panelWidth = panelWidth();
        controlPanel.setVisible(shown);
        setPanelWidth(panelWidth);
    }

    /** Returns the height of the instruments that the user has chosen, pixels. */
    int dockHeight() {
        return instruments.isVisible() && dockSplit.isMoved() ? instruments.getHeight() : dockHeight;
    }

    /** Sets the height of the instruments, pixels; the canvas keeps at least half of the window. */
    void setDockHeight(int height) {
        dockHeight = height;
        dockSplit.place(size -> size - Math.min(height, Math.max(minDockHeight(), size - minStageHeight())));
    }

    /** Shows or hides the instruments. */
    void setDockShown(boolean shown) {
        if (shown == instruments.isVisible()) {
            return;
        }
        dockHeight = dockHeight();
        instruments.setVisible(shown);
        setDockHeight(dockHeight);
        if (!panelSplit.isMoved()) {
            setPanelWidth(panelWidth);
        }
    }

    private static int minDockHeight() {
        return MIN_CHART_HEIGHT + TextSize.scaled(CHART_BARS_HEIGHT);
    }

    /** Returns the height of the canvas as half of the window, and the time line below it, pixels. */
    private int minStageHeight() {
        return (windowHeight() + 1) / 2 + stage.getDividerSize() + timeline.minHeight(windowHeight());
    }

    private int windowHeight() {
        return contents.getRootPane() == null
                ? contents.getHeight()
                : contents.getRootPane().getHeight();
    }

    /** Returns the height of the lanes that the user has chosen, pixels; empty if they have not. */
    Optional<Integer> lanesHeight() {
        return Optional.of(currentLanesHeight()).filter(height -> height != BY_ROOM);
    }

    private int currentLanesHeight() {
        return timeline.areLanesShown() && stage.isMoved() ? timeline.lanesHeight() : lanesHeight;
    }

    /** Sets the height of the lanes, pixels. */
    void setLanesHeight(int height) {
        lanesHeight = height;
        placeLanes();
    }

    /** Shows or hides the lanes. */
    void setLanesShown(boolean shown) {
        lanesHeight = currentLanesHeight();
        timeline.setLanesShown(shown);
    }

    /** Places the lanes again after a change of the number of their rows, or after they were hidden or shown. */
    private void keepLanesHeight() {
        setLanesHeight(currentLanesHeight());
    }

    private void placeLanes() {
        stage.setEnabled(timeline.areLanesShown());
        stage.place(size -> lanesHeight == BY_ROOM
                ? size - timeline.heightIn(size, windowHeight())
                : Math.max(MIN_CANVAS_HEIGHT, size - timeline.heightWith(lanesHeight)));
    }
}
