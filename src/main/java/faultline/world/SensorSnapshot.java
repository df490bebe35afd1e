package faultline.world;

import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;

/**
 * One sensor at one moment.
 *
 * @param spec how it is mounted and set now
 * @param sector its cone in the world
 * @param truth what is really there, whether it is on or not
 * @param reported what it gives the controller
 * @param intersections where the cone's outline meets obstacles' outlines, of glossy ones what sends its light back,
 *     metres; empty where it is off
 * @param faults its active faults, oldest first
 */
public record SensorSnapshot(
        SensorSpec spec,
        Sector sector,
        Reading truth,
        Reading reported,
        List<Vector2> intersections,
        List<Fault> faults) {

    public SensorSnapshot {
        intersections = List.copyOf(intersections);
        faults = List.copyOf(faults);
    }
}
