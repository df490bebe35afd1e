package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;
import faultline.paint.surface.DrawContext;

/** What the hand holds from the press of a mouse button until it lets go. */
public interface Gesture {

    /** A mouse that moves less than this while its button is down, pixels, has clicked. */
    double CLICK_TOLERANCE = 3;

    /** The mouse has come to a place of the picture. */
    void moveTo(Vector2 screen, SnapSettings snap);

    /** The button is let go. */
    default void release() {}

    /** All is to be as it was. */
    default void cancel() {}

    /** Whether what is held is gone. */
    default boolean isTargetGone() {
        return false;
    }

    default void paint(DrawContext brush) {}
}
