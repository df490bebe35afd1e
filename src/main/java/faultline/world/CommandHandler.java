package faultline.world;

import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultSequence;
import faultline.sensor.SensorSpec;
import faultline.world.Command.CommandCases;
import faultline.world.Refusal.Reason;
import java.util.AbstractList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.LongSupplier;

/** Executes commands on the world, or refuses them, and finds their inverses. */
final class CommandHandler {

    /**
     * The commands that restore the faults of a sensor or of motors: one clears all, the others inject the former ones
     * in their order. They are made when they are read, because few changes of faults are ever undone. Immutable.
     */
    static final class FaultRestoration<F> extends AbstractList<Command> {

        private final Command clearAll;
        private final FaultSequence<F> faults;
        private final Function<F, Command> inject;

        FaultRestoration(Command clearAll, FaultSequence<F> faults, Function<F, Command> inject) {
            this.clearAll = clearAll;
            this.faults = faults;
            this.inject = inject;
        }

        /** Returns a list that cannot be changed: the list itself if it is a restoration, otherwise a copy. */
        static List<Command> immutable(List<Command> commands) {
            return commands instanceof FaultRestoration<?> ? commands : List.copyOf(commands);
        }

        @Override
        public Command get(int index) {
            return index == 0 ? clearAll : inject.apply(faults.get(index - 1));
        }

        @Override
        public int size() {
            return 1 + faults.size();
        }
    }

    private final WorldSpec spec;
    private final ObstacleSet obstacles;
    private final RobotBody body;
    private final SensorArray sensors;
    private final MotionStep motionStep;
    private final LongSupplier tick;

    CommandHandler(
            WorldSpec spec,
            ObstacleSet obstacles,
            RobotBody body,
            SensorArray sensors,
            MotionStep motionStep,
            LongSupplier tick) {
        this.spec = spec;
        this.obstacles = obstacles;
        this.body = body;
        this.sensors = sensors;
        this.motionStep = motionStep;
        this.tick = tick;
    }

    /** Executes a command, or refuses it. */
    CommandResult execute(Command command) {
        // The functions are created here, because most runs have no command, and creating them earlier would delay the
        // start of a world.
        return command.match(new CommandCases<>(
                this::switchSensor,
                this::configureSensor,
                this::injectFault,
                this::clearFault,
                this::clearFaults,
                this::injectMotorFault,
                this::clearMotorFault,
                this::clearMotorFaults,
                this::moveObstacle,
                this::placeObstacle,
                this::removeObstacle,
                this::setPlatform,
                this::configureController));
    }

    private CommandResult executed(Command command, Command... inverse) {
        return executed(command, List.of(inverse));
    }

    private CommandResult executed(Command command, List<Command> inverse) {
        return new CommandResult.Executed(tick.getAsLong(), command, inverse);
    }

    private CommandResult refused(Command command, Reason reason, String subject) {
        return new CommandResult.Refused(tick.getAsLong(), command, new Refusal(reason, subject));
    }

    private CommandResult switchSensor(Command.SwitchSensor command) {
        return withSensor(command, command.sensor(), (index, old) -> {
            updateRobot(command.appliedTo(body.spec()));
            return executed(command, new Command.SwitchSensor(old.id(), old.on()));
        });
    }

    private CommandResult configureSensor(Command.ConfigureSensor command) {
        return withSensor(command, command.sensor().id(), (index, old) -> {
            updateRobot(command.appliedTo(body.spec()));
            return executed(command, new Command.ConfigureSensor(old));
        });
    }

    private CommandResult injectFault(Command.InjectFault command) {
        return withFaults(command, command.sensor(), faults -> Optional.of(faults.with(command.fault())));
    }

    private CommandResult clearFault(Command.ClearFault command) {
        return withFaults(command, command.sensor(), faults -> faults.without(command.fault()));
    }

    private CommandResult clearFaults(Command.ClearFaults command) {
        return withFaults(command, command.sensor(), faults -> Optional.of(FaultSequence.empty()));
    }

    private CommandResult injectMotorFault(Command.InjectMotorFault command) {
        return withMotorFaults(command, command.motor(), faults -> Optional.of(faults.with(command.fault())));
    }

    private CommandResult clearMotorFault(Command.ClearMotorFault command) {
        return withMotorFaults(command, command.motor(), faults -> faults.without(command.fault()));
    }

    private CommandResult clearMotorFaults(Command.ClearMotorFaults command) {
        return withMotorFaults(command, command.motor(), faults -> Optional.of(FaultSequence.empty()));
    }

    /** Changes the faults of a side's motors, as {@link #withFaults} does with those of a sensor. */
    private CommandResult withMotorFaults(
            Command command,
            MotorSide motor,
            Function<FaultSequence<MotorFault>, Optional<FaultSequence<MotorFault>>> change) {
        FaultSequence<MotorFault> faults =
                FaultSequence.copyOf(body.motorFaults().of(motor));
        Optional<FaultSequence<MotorFault>> changed = change.apply(faults);
        if (changed.isEmpty()) {
            return refused(command, Reason.UNKNOWN_MOTOR_FAULT, motor.fileName());
        }
        body.setMotorFaults(body.motorFaults().with(motor, changed.get()));
        return executed(
                command,
                new FaultRestoration<>(
                        new Command.ClearMotorFaults(motor),
                        faults,
                        fault -> new Command.InjectMotorFault(motor, fault)));
    }

    private CommandResult withSensor(
            Command command, String id, BiFunction<Integer, SensorSpec, CommandResult> change) {
        int index = body.spec().indexOf(id);
        return index < 0
                ? refused(command, Reason.UNKNOWN_SENSOR, id)
                : change.apply(index, body.spec().sensors().get(index));
    }

    /** Changes a sensor's faults. They act in the order in which they were added; the inverse restores that order. */
    private CommandResult withFaults(
            Command command, String id, Function<FaultSequence<Fault>, Optional<FaultSequence<Fault>>> change) {
        return withSensor(command, id, (index, sensor) -> {
            FaultSequence<Fault> faults = sensors.faults(index);
            Optional<FaultSequence<Fault>> changed = change.apply(faults);
            if (changed.isEmpty()) {
                return refused(command, Reason.UNKNOWN_FAULT, id);
            }
            sensors.setFaults(index, changed.get());
            return executed(
                    command,
                    new FaultRestoration<>(
                            new Command.ClearFaults(id), faults, fault -> new Command.InjectFault(id, fault)));
        });
    }

    private void updateRobot(RobotSpec changed) {
        body.setSpec(changed);
        motionStep.bodyChanged();
        sensors.configure(changed);
    }

    private CommandResult moveObstacle(Command.MoveObstacle command) {
        return withObstacle(command, command.obstacle(), placed -> {
            Obstacle old = placed.obstacle();
            // An obstacle that touches the robot may come back to where it was.
            Pose end = command.pose();
            if (!ObstacleSet.isOverlapping(body.box(), ObstacleGeometry.of(old.withPose(end)))) {
                obstacles.move(placed, end);
            } else if (motionStep.slideUntilContact(placed, end)) {
                end = obstacles.find(old.id()).orElseThrow().obstacle().pose();
            } else {
                return refused(command, Reason.OVERLAPS_ROBOT, old.id());
            }
            return new CommandResult.Executed(
                    tick.getAsLong(),
                    command,
                    new Command.MoveObstacle(old.id(), end),
                    List.of(new Command.MoveObstacle(old.id(), old.pose())));
        });
    }

    private CommandResult withObstacle(Command command, String id, Function<PlacedObstacle, CommandResult> change) {
        return obstacles.find(id).map(change).orElseGet(() -> refused(command, Reason.UNKNOWN_OBSTACLE, id));
    }

    private CommandResult placeObstacle(Command.PlaceObstacle command) {
        Obstacle obstacle = command.obstacle();
        if (obstacle.id().equals(WorldSpec.ENCLOSURE)) {
            return refused(command, Reason.RESERVED_ID, WorldSpec.ENCLOSURE);
        }
        // An obstacle that touches the robot may come back after it was removed.
        if (ObstacleSet.isOverlapping(body.box(), ObstacleGeometry.of(obstacle))) {
            return refused(command, Reason.OVERLAPS_ROBOT, obstacle.id());
        }
        if (obstacle.isMoving() && obstacles.countMovingExcept(obstacle.id()) >= spec.maxMoving()) {
            return refused(command, Reason.TOO_MANY_MOVING, Integer.toString(spec.maxMoving()));
        }
        if (obstacle.motion().isLoopTooShort()) {
            return refused(command, Reason.SHORT_LOOP, obstacle.id());
        }
        Command inverse = obstacles
                .find(obstacle.id())
                .<Command>map(old -> new Command.PlaceObstacle(old.obstacle()))
                .orElse(new Command.RemoveObstacle(obstacle.id()));
        obstacles.put(obstacle);
        return executed(command, inverse);
    }

    private CommandResult removeObstacle(Command.RemoveObstacle command) {
        return withObstacle(command, command.obstacle(), placed -> {
            Command inverse = new Command.PlaceObstacle(placed.obstacle());
            obstacles.remove(placed);
            return executed(command, inverse);
        });
    }

    private CommandResult setPlatform(Command.SetPlatform command) {
        RobotSpec old = body.spec();
        if (command.length() > old.length() || command.width() > old.width()) {
            OrientedBox box = new OrientedBox(body.pose(), command.length(), command.width());
            // A platform that has touched something and has shrunk since may get its size back.
            Optional<String> obstruction =
                    motionStep.hasCollided() ? obstacles.findOverlapped(box) : obstacles.findObstruction(box);
            if (obstruction.isPresent()) {
                return refused(command, Reason.PLATFORM_OVERLAPS, obstruction.get());
            }
        }
        updateRobot(command.appliedTo(old));
        return executed(command, new Command.SetPlatform(old.length(), old.width(), old.speed()));
    }

    /** Changes nothing in the world; the simulation passes the settings on. */
    private CommandResult configureController(Command.ConfigureController command) {
        return executed(command);
    }
}
