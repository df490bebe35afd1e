package faultline.gui.timeline;

import faultline.gui.theme.UiText;
import java.awt.Adjustable;
import javax.swing.JScrollBar;

/** The scroll bar of the lanes in time, which shows which part of the run is visible while they show less than all. */
final class TimeScrollBar extends JScrollBar {

    /** The value of the end of the run. */
    private static final int WHOLE = 1_000_000;
    /** The share of the visible part by which a click beside the thumb moves. */
    private static final double BLOCK = 0.9;
    /** The share by which a key moves. */
    private static final double UNIT = 0.1;

    private final transient LaneZoom zoom;
    private boolean shown = true;
    private boolean updating;

    TimeScrollBar(LaneZoom zoom) {
        super(Adjustable.HORIZONTAL, 0, WHOLE, 0, WHOLE);
        this.zoom = zoom;
        UiText.name(this, "timeline.scroll");
        setFocusable(false);
        // The thumb of the slider reaches into its upper edge.
        setOpaque(false);
        addAdjustmentListener(event -> {
            if (!updating) {
                zoom.moveTo(getValue() / (double) WHOLE * zoom.axis().runEnd());
            }
        });
        zoom.addListener(this::update);
        update();
    }

    /** Shows or hides the bar with the lanes. */
    void setShown(boolean newShown) {
        shown = newShown;
        update();
    }

    private void update() {
        TimeAxis axis = zoom.axis();
        setVisible(shown && !axis.isWhole());
        double share = axis.length() / axis.runEnd();
        int extent = (int) Math.max(1, Math.round(share * WHOLE));
        updating = true;
        setValues((int) Math.round(axis.start() / axis.runEnd() * WHOLE), extent, 0, WHOLE);
        setBlockIncrement((int) Math.max(1, BLOCK * extent));
        setUnitIncrement((int) Math.max(1, UNIT * extent));
        updating = false;
    }
}
