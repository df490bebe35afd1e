package faultline.world;

import faultline.geometry.OrientedBox;
import faultline.robot.RobotSpec;
import java.util.Optional;

/** Carries out commands on the world, or refuses them with one sentence. */
final class CommandHandler {

    private static final Optional<String> SUCCESS = Optional.empty();

    private final WorldSpec spec;
    private final ObstacleSet obstacleSet;
    private final RobotBody body;
    private final SensorArray sensors;
    private final MotionStep motionStep;

    CommandHandler(WorldSpec spec, ObstacleSet field, RobotBody body, SensorArray sensors, MotionStep traffic) {
        this.spec = spec;
        this.obstacleSet = field;
        this.body = body;
        this.sensors = sensors;
        this.motionStep = traffic;
    }

    Optional<String> execute(Command command) {
        if (command instanceof Command.MoveObstacle move) {
            return moveObstacle(move);
        }
        if (command instanceof Command.PlaceObstacle put) {
            return placeObstacle(put.obstacle());
        }
        if (command instanceof Command.RemoveObstacle remove) {
            return removeObstacle(remove.obstacle());
        }
        if (command instanceof Command.SetPlatform platform) {
            return setPlatform(platform);
        }
        return executeOnSensor(command);
    }

    private Optional<String> executeOnSensor(Command command) {
        String id = sensorId(command);
        int sensor = body.spec().indexOf(id);
        if (sensor < 0) {
            return Optional.of("the robot has no sensor " + id);
        }
        if (command instanceof Command.SwitchSensor change) {
            updateRobot(body.spec().withSensor(body.spec().sensors().get(sensor).withOn(change.on())));
        } else if (command instanceof Command.ConfigureSensor change) {
            updateRobot(body.spec().withSensor(change.sensor()));
        } else if (command instanceof Command.InjectFault change) {
            sensors.faults(sensor).add(change.fault());
        } else if (command instanceof Command.ClearFault change) {
            if (!sensors.faults(sensor).remove(change.fault())) {
                return Optional.of(id + " has no such fault");
            }
        } else {
            sensors.faults(sensor).clear();
        }
        return SUCCESS;
    }

    /** The id of the sensor that a command of none of the other kinds is about. */
    static String sensorId(Command command) {
        if (command instanceof Command.SwitchSensor change) {
            return change.sensor();
        }
        if (command instanceof Command.ConfigureSensor change) {
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

    private void updateRobot(RobotSpec changed) {
        body.setSpec(changed);
        sensors.configure(changed);
    }

    private Optional<String> moveObstacle(Command.MoveObstacle move) {
        int owner = obstacleSet.indexOf(move.obstacle());
        if (owner < 0) {
            return unknownObstacleRefusal(move.obstacle());
        }
        ObstacleGeometry there =
                ObstacleGeometry.of(obstacleSet.obstacles().get(owner).withPose(move.pose()));
        if (ObstacleSet.isClear(body.box(), there)) {
            obstacleSet.move(owner, move.pose());
            return SUCCESS;
        }
        return motionStep.slideUntilContact(owner, move.pose())
                ? SUCCESS
                : Optional.of(overlapRefusal(move.obstacle()));
    }

    private Optional<String> placeObstacle(Obstacle obstacle) {
        if (obstacle.id().equals(WorldSpec.ENCLOSURE)) {
            return Optional.of(WorldSpec.ENCLOSURE + " is the name of the enclosing wall");
        }
        if (!ObstacleSet.isClear(body.box(), ObstacleGeometry.of(obstacle))) {
            return Optional.of(overlapRefusal(obstacle.id()));
        }
        if (obstacle.motion().isPresent() && countOthersMoving(obstacle.id()) >= spec.maxMoving()) {
            return Optional.of("at most " + spec.maxMoving() + " obstacles may move");
        }
        obstacleSet.put(obstacle);
        return SUCCESS;
    }

    private long countOthersMoving(String id) {
        return obstacleSet.obstacles().stream()
                .filter(other -> other.motion().isPresent() && !other.id().equals(id))
                .count();
    }

    private Optional<String> removeObstacle(String id) {
        int owner = obstacleSet.indexOf(id);
        if (owner < 0) {
            return unknownObstacleRefusal(id);
        }
        obstacleSet.remove(owner);
        return SUCCESS;
    }

    private Optional<String> setPlatform(Command.SetPlatform platform) {
        OrientedBox grown = new OrientedBox(body.pose(), platform.length(), platform.width());
        String obstructing = obstacleSet.findObstruction(grown);
        boolean grows = platform.length() > body.spec().length()
                || platform.width() > body.spec().width();
        if (grows && !obstructing.isEmpty()) {
            return Optional.of("the robot has no room for that platform: it would overlap " + obstructing);
        }
        updateRobot(body.spec().withPlatform(platform.length(), platform.width(), platform.speed()));
        return SUCCESS;
    }

    private static Optional<String> unknownObstacleRefusal(String id) {
        return Optional.of("there is no obstacle " + id);
    }

    private static String overlapRefusal(String id) {
        return id + " cannot be put there: it would overlap the robot";
    }
}
