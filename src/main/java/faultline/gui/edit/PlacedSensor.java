package faultline.gui.edit;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.SensorReference;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A sensor with its place in a robot's list, and the commands about it with their places in the timeline, so that it
 * can be removed and put back.
 *
 * @param sensor the sensor
 * @param index the index of the sensor in the robot's list
 * @param commands the commands by their indices in the timeline
 */
record PlacedSensor(SensorSpec sensor, int index, SortedMap<Integer, TimedCommand> commands) {

    /** Returns the sensor of a scenario with an id; empty if there is none. */
    static Optional<PlacedSensor> find(Scenario scenario, String id) {
        SimulationSetup setup = scenario.setup();
        SortedMap<Integer, TimedCommand> commands = new TreeMap<>();
        for (int i = 0; i < setup.timeline().size(); i++) {
            if (isAbout(setup.timeline().get(i), id)) {
                commands.put(i, setup.timeline().get(i));
            }
        }
        return setup.robot()
                .sensor(id)
                .map(sensor -> new PlacedSensor(sensor, setup.robot().indexOf(id), commands));
    }

    private static boolean isAbout(TimedCommand timed, String id) {
        return SensorReference.in(timed.command()).filter(id::equals).isPresent();
    }

    /** Returns a scenario with this sensor and its commands. */
    Scenario addedTo(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        List<SensorSpec> sensors = new ArrayList<>(setup.robot().sensors());
        sensors.add(Math.min(index, sensors.size()), sensor);
        List<TimedCommand> timeline = new ArrayList<>(setup.timeline());
        commands.forEach((place, command) -> timeline.add(Math.min(place, timeline.size()), command));
        return with(scenario, sensors, timeline);
    }

    /** Returns a scenario without this sensor and all commands about it. */
    Scenario removedFrom(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        return with(
                scenario,
                setup.robot().sensors().stream()
                        .filter(other -> !other.id().equals(sensor.id()))
                        .toList(),
                setup.timeline().stream()
                        .filter(timed -> !isAbout(timed, sensor.id()))
                        .toList());
    }

    private static Scenario with(Scenario scenario, List<SensorSpec> sensors, List<TimedCommand> timeline) {
        RobotSpec robot = scenario.setup().robot().withSensors(sensors);
        return scenario.withSetup(scenario.setup().withRobot(robot).withTimeline(timeline));
    }
}
