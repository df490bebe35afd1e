package faultline.gui.canvas.tool;

/** The target of a context menu of the canvas. */
public enum MenuTarget {
    /** An obstacle or one of its waypoints; the right button has selected the obstacle. */
    OBSTACLE,
    /** The robot. */
    ROBOT,
    /** The cone of a sensor. */
    SENSOR,
    /** The floor. */
    FLOOR
}
