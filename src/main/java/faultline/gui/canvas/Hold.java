package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.edit.Snap;
import faultline.paint.Brush;

/** What the hand holds from the press of a mouse button until it lets go. */
interface Hold {

    /** A mouse that moves less than this while its button is down, pixels, has clicked. */
    double CLICK = 3;

    /** The mouse has come to a place of the picture. */
    void to(Vec screen, Snap snap);

    /** The button is let go. */
    default void release() {
    }

    /** All is to be as it was. */
    default void cancel() {
    }

    /** Whether what is held is gone. */
    default boolean isLost() {
        return false;
    }

    default void paint(Brush brush) {
    }
}
