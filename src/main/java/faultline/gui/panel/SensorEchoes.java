package faultline.gui.panel;

import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the user last asked of each sensor, shared by all controls that set a part of it, so that none takes back what another has just set.
 */
final class SensorEchoes {

    private final Map<String, Echo<SensorSpec>> echoes = new HashMap<>();

    /** Takes note of what is true now. */
    void told(List<SensorSnapshot> sensors) {
        for (SensorSnapshot sensor : sensors) {
            echoes.computeIfAbsent(sensor.spec().id(), id -> new Echo<>(sensor.spec())).told(sensor.spec());
        }
    }

    /** How a sensor is to show. */
    SensorSpec of(String sensor) {
        return echoes.get(sensor).value();
    }

    /** Takes note of what the user asks for. */
    SensorSpec ask(SensorSpec wanted) {
        return echoes.get(wanted.id()).ask(wanted);
    }
}
