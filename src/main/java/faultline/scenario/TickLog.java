package faultline.scenario;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.geometry.Pose;
import faultline.io.MessageText;
import faultline.scenario.xml.Allowed;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** Records every tick of a run, about 200 bytes each with eight sensors. */
final class TickLog implements TickObserver {

    /**
     * A tick.
     *
     * @param pose the pose of the robot
     * @param state the name of the controller's state
     * @param readings the true and the reported reading of each sensor in turn, encoded as in {@link Reading}
     */
    private record LoggedTick(Pose pose, String state, double[] readings) {}

    private final List<LoggedTick> ticks = new ArrayList<>();
    private List<String> sensors = List.of();

    @Override
    public void observe(Simulation simulation) {
        if (ticks.isEmpty()) {
            sensors = simulation.robot().sensors().stream().map(SensorSpec::id).toList();
        }
        double[] readings = new double[2 * sensors.size()];
        for (int i = 0; i < sensors.size(); i++) {
            readings[2 * i] = simulation.trueReading(i);
            readings[2 * i + 1] = simulation.reportedReading(i);
        }
        ticks.add(
                new LoggedTick(simulation.pose(), simulation.telemetry().state().name(), readings));
    }

    Pose pose(int tick) {
        return ticks.get(tick).pose;
    }

    String state(int tick) {
        return ticks.get(tick).state;
    }

    Reading trueReading(int tick, String sensor) {
        return new Reading(ticks.get(tick).readings[2 * sensorIndex(sensor)]);
    }

    Reading reportedReading(int tick, String sensor) {
        return new Reading(ticks.get(tick).readings[2 * sensorIndex(sensor) + 1]);
    }

    private int sensorIndex(String sensor) {
        int index = sensors.indexOf(sensor);
        if (index < 0) {
            throw new IllegalArgumentException("the robot has no sensor " + MessageText.quoted(sensor) + ", only "
                    + Allowed.names(sensors, sensor));
        }
        return index;
    }
}
