package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;

/**
 * A function of the left button that replaces selecting and moving until it is finished. Positions are in the world,
 * metres, and snapped.
 */
public interface Tool {

    /** Handles a press of the button; {@code twice} for the second press of a double click. */
    void press(Vector2 at, boolean twice);

    /** Handles a move of the mouse, with the button down or up. */
    void move(Vector2 at, boolean down);

    /** Handles a release of the button. */
    void release(Vector2 at);

    /** Handles a move of the point that keys move. */
    default void moveByKey(Vector2 at) {
        move(at, false);
    }

    /** Completes the tool with the points so far. */
    void finish();

    /** Completes the tool by key; {@code at} is the cursor, or the centre of the view. */
    default void confirm(Vector2 at) {
        finish();
    }

    default void removeLastPoint() {}

    /** Returns whether the tool is done, so that the mouse selects and moves again. */
    boolean isDone();

    void paint(DrawContext context);
}
