package faultline.gui.edit;

import faultline.geometry.Angles;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The sets of sensors that are on: the two that following a wall needs, the third that an acute inner corner needs
 * besides, or all.
 */
public final class SensorPresets {

    /** Ahead, towards the wall, and ahead on the far side; radians with the wall on the left. */
    private static final List<Double> BEARINGS = List.of(0.0, Math.PI / 2, -Math.PI / 4);

    private SensorPresets() {}

    /**
     * Returns the commands that switch two, three or, if {@code count} is greater, all sensors on and the others off;
     * only those that change something.
     */
    public static List<Command> commands(RobotSpec robot, boolean wallOnLeft, int count) {
        Set<String> wanted = new HashSet<>();
        if (count > BEARINGS.size()) {
            robot.sensors().forEach(sensor -> wanted.add(sensor.id()));
        } else {
            BEARINGS.subList(0, count).forEach(bearing -> robot.sensors().stream()
                    .min(Comparator.comparingDouble(sensor -> angleBetween(sensor, wallOnLeft ? bearing : -bearing)))
                    .ifPresent(sensor -> wanted.add(sensor.id())));
        }
        return robot.sensors().stream()
                .filter(sensor -> sensor.on() != wanted.contains(sensor.id()))
                .<Command>map(sensor -> new Command.SwitchSensor(sensor.id(), !sensor.on()))
                .toList();
    }

    private static double angleBetween(SensorSpec sensor, double bearing) {
        return Math.abs(Angles.difference(bearing, sensor.bearing()));
    }
}
