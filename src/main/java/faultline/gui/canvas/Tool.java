package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.paint.Brush;

/** What the left button does in place of selecting and moving, until it is done. Places are in the world, metres, and snapped. */
interface Tool {

    /** The button goes down; the second time in quick succession for a double click. */
    void press(Vec at, boolean twice);

    /** The mouse moves, with the button up or down. */
    void move(Vec at, boolean down);

    /** The button goes up. */
    void release(Vec at);

    /** The user has no more to give. */
    void finish();

    /** Takes the last point back. */
    default void back() {
    }

    /** Whether all is done, so that the mouse selects and moves again. */
    boolean isDone();

    void paint(Brush brush);
}
