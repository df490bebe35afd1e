package faultline.gui.panel;

import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the user last asked of each sensor, shared by all controls that set a part of it, so that none takes back what
 * another has just set.
 */
final class OptimisticSensors {

    private final Map<String, OptimisticValue<SensorSpec>> values = new HashMap<>();

    /** Takes note of what is true now. */
    void update(List<SensorSnapshot> sensors) {
        for (SensorSnapshot sensor : sensors) {
            values.computeIfAbsent(sensor.spec().id(), id -> new OptimisticValue<>(sensor.spec()))
                    .update(sensor.spec());
        }
    }

    /** How a sensor is to show. */
    SensorSpec spec(String sensor) {
        return values.get(sensor).value();
    }

    /** Takes note of what the user asks for. */
    SensorSpec request(SensorSpec wanted) {
        return values.get(wanted.id()).request(wanted);
    }
}
