package faultline.paint.scene;

import java.util.EnumSet;
import java.util.Set;

/**
 * A part of the scene that can be shown or hidden. The obstacles, the robot, its contacts and the first collision
 * always show.
 */
public enum Layer {
    /** The grid. */
    GRID,
    /** The way-points of moving obstacles. */
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

    /**
     * The layers that show where nobody chose otherwise.
     *
     * @return a new set of all but {@link #LABELS}
     */
    public static Set<Layer> defaults() {
        return EnumSet.complementOf(EnumSet.of(LABELS));
    }
}
