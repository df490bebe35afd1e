package faultline.engine;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.world.World;

/**
 * The state of the controller, and whether a sensor or motor is faulty, while the robot drives to a point of its path.
 * Packed into a small number, because a path has many points.
 */
public final class PathTag {

    /** The tag of a controller in its first state, without faults. */
    public static final int NONE = 0;

    /** The index of all states that are not the wall follower's. */
    public static final int OTHER_STATE = FollowerState.values().length;

    private static final int FAULT_BIT = 64;

    private PathTag() {}

    /**
     * {@return the tag of a state of the controller}
     *
     * @param state the state
     * @param faulty whether a sensor or motor is faulty
     */
    public static int of(ControllerState state, boolean faulty) {
        return (state instanceof FollowerState follower ? follower.ordinal() : OTHER_STATE) + (faulty ? FAULT_BIT : 0);
    }

    static int of(ControllerState state, World world) {
        return of(state, isFaulty(world));
    }

    private static boolean isFaulty(World world) {
        for (int i = world.robot().sensors().size() - 1; i >= 0; i--) {
            if (!world.faults(i).isEmpty()) {
                return true;
            }
        }
        return !world.motorFaults().left().isEmpty()
                || !world.motorFaults().right().isEmpty();
    }

    /**
     * {@return the index of the state: its ordinal in {@link FollowerState}, or {@link #OTHER_STATE}}
     *
     * @param tag the tag
     */
    public static int stateIndex(int tag) {
        return tag % FAULT_BIT;
    }

    /**
     * {@return whether a sensor or motor is faulty}
     *
     * @param tag the tag
     */
    public static boolean isFaulty(int tag) {
        return tag >= FAULT_BIT;
    }
}
