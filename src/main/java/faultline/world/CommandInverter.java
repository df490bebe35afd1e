package faultline.world;

import faultline.sensor.Fault;
import java.util.ArrayList;
import java.util.List;

/** Says what would take a command back, as the world stands before it. */
final class CommandInverter {

    private final ObstacleSet obstacleSet;
    private final RobotBody body;
    private final SensorArray sensors;

    CommandInverter(ObstacleSet field, RobotBody body, SensorArray sensors) {
        this.obstacleSet = field;
        this.body = body;
        this.sensors = sensors;
    }

    /**
     * The commands that restore what a command is about to change, in order; empty where it names something unknown.
     */
    List<Command> inverseOf(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return obstacleSet
                    .obstacle(move.obstacle())
                    .map(now -> List.<Command>of(new Command.MoveObstacle(now.id(), now.pose())))
                    .orElse(List.of());
        }
        if (command instanceof Command.PlaceObstacle put) {
            String id = put.obstacle().id();
            return List.of(obstacleSet
                    .obstacle(id)
                    .<Command>map(Command.PlaceObstacle::new)
                    .orElse(new Command.RemoveObstacle(id)));
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return obstacleSet
                    .obstacle(remove.obstacle())
                    .map(now -> List.<Command>of(new Command.PlaceObstacle(now)))
                    .orElse(List.of());
        }
        if (command instanceof Command.SetPlatform) {
            return List.of(new Command.SetPlatform(
                    body.spec().length(), body.spec().width(), body.spec().speed()));
        }
        return inverseOnSensor(command);
    }

    private List<Command> inverseOnSensor(Command command) {
        String id = CommandHandler.sensorId(command);
        int sensor = body.spec().indexOf(id);
        if (sensor < 0) {
            return List.of();
        }
        if (command instanceof Command.SwitchSensor) {
            return List.of(new Command.SwitchSensor(
                    id, body.spec().sensors().get(sensor).on()));
        }
        if (command instanceof Command.ConfigureSensor) {
            return List.of(new Command.ConfigureSensor(body.spec().sensors().get(sensor)));
        }
        return restoreFaults(id, sensors.faults(sensor));
    }

    /** Faults act in the order in which they came, so that order comes back with them. */
    private static List<Command> restoreFaults(String sensor, List<Fault> faults) {
        List<Command> anew = new ArrayList<>();
        anew.add(new Command.ClearFaults(sensor));
        faults.forEach(fault -> anew.add(new Command.InjectFault(sensor, fault)));
        return anew;
    }
}
