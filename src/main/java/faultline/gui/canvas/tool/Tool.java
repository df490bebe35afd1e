package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;

/**
 * What the left button does in place of selecting and moving, until it is done. Places are in the world, metres, and
 * snapped.
 */
public interface Tool {

    /** The button goes down; the second time in quick succession for a double click. */
    void press(Vector2 at, boolean twice);

    /** The mouse moves, with the button up or down. */
    void move(Vector2 at, boolean down);

    /** The button goes up. */
    void release(Vector2 at);

    /** The user has no more to give. */
    void finish();

    /** Takes the last point back. */
    default void removeLastPoint() {}

    /** Whether all is done, so that the mouse selects and moves again. */
    boolean isDone();

    void paint(DrawContext brush);
}
