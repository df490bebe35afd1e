package faultline.paint.scene;

import java.util.EnumSet;
import java.util.Set;

/**
 * A layer of the scene that can be shown or hidden. Obstacles, the robot, its contacts and the first collision are
 * always shown.
 */
public enum Layer {
    /** The grid. */
    GRID,
    /** The waypoints of moving obstacles. */
    ROUTES,
    /** The robot's path. */
    PATH,
    /** The robot's path coloured by the controller's state. */
    PATH_STATES,
    /** The robot's path with the stretches on which a sensor or motor was faulty. */
    PATH_FAULTS,
    /** The sensors' cones, numbers and readings. */
    CONES,
    /** Rings where the cones' outlines meet obstacles. */
    INTERSECTIONS,
    /** The obstacles' names. */
    LABELS,
    /** The scale bar. */
    SCALE_BAR;

    /** Returns a new set of the layers that are shown by default: all but the labels and the colours of the path. */
    public static Set<Layer> defaults() {
        return EnumSet.complementOf(EnumSet.of(LABELS, PATH_STATES, PATH_FAULTS));
    }
}
