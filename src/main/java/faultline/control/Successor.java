package faultline.control;

import faultline.robot.WheelSpeeds;

/** A controller that can begin while the robot moves. */
public interface Successor extends Controller {

    /**
     * Begins after another controller, before the first decision.
     *
     * @param tick the tick of the first observation
     * @param wheels the speeds of the robot's wheels at that tick
     */
    void begin(long tick, WheelSpeeds wheels);
}
