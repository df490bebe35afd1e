package faultline.world;

import faultline.sensor.Fault;
import java.util.ArrayList;
import java.util.List;

/** Says what would take a command back, as the world stands before it. */
final class CommandUndo {

    private final ObstacleField field;
    private final RobotBody body;
    private final SensorBank sensors;

    CommandUndo(ObstacleField field, RobotBody body, SensorBank sensors) {
        this.field = field;
        this.body = body;
        this.sensors = sensors;
    }

    /** The commands that restore what a command is about to change, in order; empty where it names something unknown. */
    List<Command> of(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return field.obstacle(move.obstacle()).map(now -> List.<Command>of(new Command.MoveObstacle(now.id(), now.pose()))).orElse(List.of());
        }
        if (command instanceof Command.PutObstacle put) {
            String id = put.obstacle().id();
            return List.of(field.obstacle(id).<Command>map(Command.PutObstacle::new).orElse(new Command.RemoveObstacle(id)));
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return field.obstacle(remove.obstacle()).map(now -> List.<Command>of(new Command.PutObstacle(now))).orElse(List.of());
        }
        if (command instanceof Command.SetPlatform) {
            return List.of(new Command.SetPlatform(body.spec().length(), body.spec().width(), body.spec().speed()));
        }
        return ofSensor(command);
    }

    private List<Command> ofSensor(Command command) {
        String id = CommandDesk.sensorOf(command);
        int sensor = body.spec().indexOf(id);
        if (sensor < 0) {
            return List.of();
        }
        if (command instanceof Command.SwitchSensor) {
            return List.of(new Command.SwitchSensor(id, body.spec().sensors().get(sensor).on()));
        }
        if (command instanceof Command.TuneSensor) {
            return List.of(new Command.TuneSensor(body.spec().sensors().get(sensor)));
        }
        return faultsAnew(id, sensors.faults(sensor));
    }

    /** Faults act in the order in which they came, so that order comes back with them. */
    private static List<Command> faultsAnew(String sensor, List<Fault> faults) {
        List<Command> anew = new ArrayList<>();
        anew.add(new Command.ClearFaults(sensor));
        faults.forEach(fault -> anew.add(new Command.InjectFault(sensor, fault)));
        return anew;
    }
}
