package faultline.world;

import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.sensor.Fault;
import faultline.sensor.FaultSequence;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;

/**
 * One sensor at one moment.
 *
 * @param spec its mounting and settings
 * @param sector its cone in the world
 * @param truth the reading without noise and faults, whether the sensor is on or not
 * @param reported the reading that the controller gets
 * @param intersections the points where the cone's outline meets obstacles' outlines, for specular ones their
 *     reflecting part, metres; empty if the sensor is off
 * @param faults its active faults, oldest first
 */
public record SensorSnapshot(
        SensorSpec spec,
        Sector sector,
        Reading truth,
        Reading reported,
        List<Vector2> intersections,
        List<Fault> faults) {

    /**
     * Creates a snapshot from copies of the lists.
     *
     * @param spec its mounting and settings
     * @param sector its cone in the world
     * @param truth the reading without noise and faults, whether the sensor is on or not
     * @param reported the reading that the controller gets
     * @param intersections the points where the cone's outline meets obstacles' outlines, for specular ones their
     *     reflecting part, metres; empty if the sensor is off
     * @param faults its active faults, oldest first
     */
    public SensorSnapshot {
        intersections = List.copyOf(intersections);
        faults = FaultSequence.copyOf(faults);
    }
}
