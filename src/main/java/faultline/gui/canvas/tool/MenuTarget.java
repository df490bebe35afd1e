package faultline.gui.canvas.tool;

/** The target of a context menu of the canvas. */
public enum MenuTarget {
    /** An obstacle, which the right button has selected. */
    OBSTACLE,
    /** The robot. */
    ROBOT,
    /** The cone of a sensor. */
    SENSOR,
    /** The floor. */
    FLOOR
}
