package faultline.world;

import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.sensor.Fault;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The robot's first contact with an obstacle.
 *
 * @param point the contact point, metres; the middle of the contact if a side lies flush along an obstacle, and one of
 *     the points if the body touches the obstacle with several sides
 * @param time seconds, exact within the tick
 * @param tick the tick in which it happened
 * @param obstacle the id of the obstacle, or {@link WorldSpec#ENCLOSURE}
 * @param faults the faults active then, by sensor id, sorted; sensors without faults are omitted
 * @param switchedOff the ids of the sensors that were switched off then, in the robot's order
 * @param motorFaults the faults of the motors active then
 */
public record Collision(
        Vector2 point,
        double time,
        long tick,
        String obstacle,
        Map<String, List<Fault>> faults,
        List<String> switchedOff,
        MotorFaults motorFaults) {

    /**
     * Creates a collision from copies of the faults and the sensors that are off.
     *
     * @param point the contact point, metres; the middle of the contact if a side lies flush along an obstacle, and one
     *     of the points if the body touches the obstacle with several sides
     * @param time seconds, exact within the tick
     * @param tick the tick in which it happened
     * @param obstacle the id of the obstacle, or {@link WorldSpec#ENCLOSURE}
     * @param faults the faults active then, by sensor id, sorted; sensors without faults are omitted
     * @param switchedOff the ids of the sensors that were switched off then, in the robot's order
     * @param motorFaults the faults of the motors active then
     */
    public Collision {
        faults = Collections.unmodifiableMap(new TreeMap<>(faults));
        switchedOff = List.copyOf(switchedOff);
    }
}
