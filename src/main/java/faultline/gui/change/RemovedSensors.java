package faultline.gui.change;

import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The sensors of a run that changes of its setup have removed. The changes of their settings are hidden until undo
 * returns the sensors as they were edited last: then the run has them from the start as before, and the changes at
 * their ticks.
 */
final class RemovedSensors {

    private final Map<String, RemovedSensor> sensors = new HashMap<>();

    /** A sensor at the start of the run, and as edited. */
    private record RemovedSensor(SensorSpec atStart, SensorSpec edited) {}

    /**
     * Returns these sensors and those that a change of the setup removes, without those of the changed robot.
     *
     * @param atStart the robot at the start of the run
     * @param edited the same robot after the edits
     * @param changed the changed robot
     */
    RemovedSensors after(RobotSpec atStart, RobotSpec edited, RobotSpec changed) {
        RemovedSensors result = new RemovedSensors();
        result.sensors.putAll(sensors);
        for (SensorSpec sensor : atStart.sensors()) {
            edited.sensor(sensor.id())
                    .ifPresent(now -> result.sensors.put(sensor.id(), new RemovedSensor(sensor, now)));
        }
        result.sensors.keySet().removeAll(changed.sensorIds());
        return result;
    }

    /** Returns the robot at the start of the run, given a changed one that may have removed sensors again. */
    RobotSpec returnedTo(RobotSpec changed) {
        RobotSpec atStart = changed;
        for (RemovedSensor removed : sensors.values()) {
            if (changed.sensors().contains(removed.edited())) {
                atStart = atStart.withSensor(removed.atStart());
            }
        }
        return atStart;
    }

    /** Returns whether a command is about a removed sensor. */
    boolean isAbout(Command command) {
        return find(command).isPresent();
    }

    /** Returns whether a command is about a removed sensor whose id another sensor of a changed robot has. */
    boolean isReplaced(Command command, RobotSpec changed) {
        return find(command)
                .map(RemovedSensor::edited)
                .filter(edited ->
                        changed.indexOf(edited.id()) >= 0 && !changed.sensors().contains(edited))
                .isPresent();
    }

    private Optional<RemovedSensor> find(Command command) {
        return SensorReference.in(command).map(sensors::get);
    }

    RemovedSensors renamed(Rename rename) {
        RemovedSensors result = new RemovedSensors();
        for (RemovedSensor removed : sensors.values()) {
            SensorSpec atStart = rename.rename(removed.atStart());
            result.sensors.put(atStart.id(), new RemovedSensor(atStart, rename.rename(removed.edited())));
        }
        return result;
    }
}
