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
    /** The sensors' cones, numbers and readings. */
    CONES,
    /** Rings where the cones' outlines meet obstacles. */
    INTERSECTIONS,
    /** The obstacles' names. */
    LABELS,
    /** The scale bar. */
    SCALE_BAR;

    /** Returns a new set of the layers that are shown by default: all but {@link #LABELS}. */
    public static Set<Layer> defaults() {
        return EnumSet.complementOf(EnumSet.of(LABELS));
    }
}
