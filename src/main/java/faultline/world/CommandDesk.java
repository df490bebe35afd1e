package faultline.world;

import faultline.geometry.Box;
import faultline.robot.RobotSpec;
import java.util.Optional;

/** Carries out commands on the world, or refuses them with one sentence. */
final class CommandDesk {

    private static final Optional<String> DONE = Optional.empty();

    private final WorldSpec spec;
    private final ObstacleField field;
    private final RobotBody body;
    private final SensorBank sensors;
    private final Traffic traffic;

    CommandDesk(WorldSpec spec, ObstacleField field, RobotBody body, SensorBank sensors, Traffic traffic) {
        this.spec = spec;
        this.field = field;
        this.body = body;
        this.sensors = sensors;
        this.traffic = traffic;
    }

    Optional<String> apply(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return move(move);
        }
        if (command instanceof Command.PutObstacle put) {
            return put(put.obstacle());
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return remove(remove.obstacle());
        }
        if (command instanceof Command.SetPlatform platform) {
            return setPlatform(platform);
        }
        return applyToSensor(command);
    }

    private Optional<String> applyToSensor(Command command) {
        String id = sensorOf(command);
        int sensor = body.spec().indexOf(id);
        if (sensor < 0) {
            return Optional.of("the robot has no sensor " + id);
        }
        if (command instanceof Command.SwitchSensor change) {
            refit(body.spec().withSensor(body.spec().sensors().get(sensor).withOn(change.on())));
        } else if (command instanceof Command.TuneSensor change) {
            refit(body.spec().withSensor(change.sensor()));
        } else if (command instanceof Command.InjectFault change) {
            sensors.faults(sensor).add(change.fault());
        } else if (command instanceof Command.ClearFault change) {
            if (!sensors.faults(sensor).remove(change.fault())) {
                return Optional.of(id + " has no such fault");
            }
        } else {
            sensors.faults(sensor).clear();
        }
        return DONE;
    }

    /** The id of the sensor that a command of none of the other kinds is about. */
    static String sensorOf(Command command) {
        if (command instanceof Command.SwitchSensor change) {
            return change.sensor();
        }
        if (command instanceof Command.TuneSensor change) {
            return change.sensor().id();
        }
        if (command instanceof Command.InjectFault change) {
            return change.sensor();
        }
        if (command instanceof Command.ClearFault change) {
            return change.sensor();
        }
        return ((Command.ClearFaults) command).sensor();
    }

    private void refit(RobotSpec changed) {
        body.rebuild(changed);
        sensors.refit(changed);
    }

    private Optional<String> move(Command.MoveObstacle move) {
        int owner = field.indexOf(move.obstacle());
        if (owner < 0) {
            return unknownObstacle(move.obstacle());
        }
        Outline there = Outline.of(field.obstacles().get(owner).at(move.pose()));
        if (ObstacleField.isClear(body.box(), there)) {
            field.move(owner, move.pose());
            return DONE;
        }
        return traffic.slide(owner, move.pose()) ? DONE : Optional.of(overlap(move.obstacle()));
    }

    private Optional<String> put(Obstacle obstacle) {
        if (obstacle.id().equals(WorldSpec.ENCLOSURE)) {
            return Optional.of(WorldSpec.ENCLOSURE + " is the name of the enclosing wall");
        }
        if (!ObstacleField.isClear(body.box(), Outline.of(obstacle))) {
            return Optional.of(overlap(obstacle.id()));
        }
        if (obstacle.motion().isPresent() && othersMoving(obstacle.id()) >= spec.maxMoving()) {
            return Optional.of("at most " + spec.maxMoving() + " obstacles may move");
        }
        field.put(obstacle);
        return DONE;
    }

    private long othersMoving(String id) {
        return field.obstacles().stream().filter(other -> other.motion().isPresent() && !other.id().equals(id)).count();
    }

    private Optional<String> remove(String id) {
        int owner = field.indexOf(id);
        if (owner < 0) {
            return unknownObstacle(id);
        }
        field.remove(owner);
        return DONE;
    }

    private Optional<String> setPlatform(Command.SetPlatform platform) {
        Box grown = new Box(body.pose(), platform.length(), platform.width());
        String obstructing = field.obstructing(grown);
        boolean grows = platform.length() > body.spec().length() || platform.width() > body.spec().width();
        if (grows && !obstructing.isEmpty()) {
            return Optional.of("the robot has no room for that platform: it would overlap " + obstructing);
        }
        refit(body.spec().withPlatform(platform.length(), platform.width(), platform.speed()));
        return DONE;
    }

    private static Optional<String> unknownObstacle(String id) {
        return Optional.of("there is no obstacle " + id);
    }

    private static String overlap(String id) {
        return id + " cannot be put there: it would overlap the robot";
    }
}
