package faultline.gui.panel;

import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The sensor settings last requested by the user, shared by all controls that change a part of them, so that no control
 * reverts the change of another.
 */
final class OptimisticSensors {

    private final Map<String, OptimisticValue<SensorSpec>> values = new HashMap<>();

    /** Updates the settings from a snapshot. */
    void update(List<SensorSnapshot> sensors) {
        for (SensorSnapshot sensor : sensors) {
            values.computeIfAbsent(sensor.spec().id(), id -> new OptimisticValue<>(sensor.spec()))
                    .update(sensor.spec());
        }
    }

    /** Returns the settings to show for a sensor. */
    SensorSpec spec(String sensor) {
        return values.get(sensor).value();
    }

    /** Stores requested settings and returns them. */
    SensorSpec request(SensorSpec requested) {
        return values.get(requested.id()).request(requested);
    }
}
