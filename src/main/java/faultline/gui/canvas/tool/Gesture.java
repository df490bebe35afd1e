package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;
import faultline.paint.surface.DrawContext;
import java.util.function.UnaryOperator;

/** The effect of a mouse drag, from the press of the button to its release. */
public interface Gesture {

    /** A mouse that moves less than this while the button is down has clicked, pixels. */
    double CLICK_TOLERANCE = 3;

    /** Handles a move of the mouse to a position on the canvas. */
    void moveTo(Vector2 screen, SnapSettings snap);

    /** Handles the release of the button. */
    default void release() {}

    /** Reverts everything that the gesture has done. */
    default void cancel() {}

    /** Ends the gesture where it is, without another effect, because its objects no longer exist. */
    default void discard() {}

    /** Returns whether an object of the gesture no longer exists. */
    default boolean isTargetGone() {
        return false;
    }

    /** Follows a change of the ids of obstacles, given what returns the next id for the present one. */
    default void renameObstacles(UnaryOperator<String> nextId) {}

    default void paint(DrawContext context) {}
}
