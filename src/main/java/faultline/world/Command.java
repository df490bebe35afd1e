package faultline.world;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import java.util.function.Function;

/**
 * A change to a running world from outside: by a window, a scenario's timeline or a test. A command is a plain value.
 * It is executed at the start of a tick and recorded in the journal with that tick. A command that names something
 * unknown, that would make an obstacle overlap the robot or a larger platform overlap an obstacle, or that breaks
 * another rule of {@link Refusal.Reason}, is refused and changes nothing (see {@link World#execute}).
 *
 * <p>Code that depends on the kind of command gives {@link CommandCases}, so that a new command does not compile until
 * it is handled everywhere.
 */
public sealed interface Command {

    /**
     * {@return the result of the function for this kind of command}
     *
     * @param <R> the type of the result
     * @param cases a function for each kind
     */
    <R> R match(CommandCases<R> cases);

    /**
     * {@return whether this command changes the setup of a run; all others belong to a time of the run: switches of
     * sensors, faults and repairs}
     */
    default boolean changesSetup() {
        return match(CommandCases.CHANGES_SETUP);
    }

    /**
     * {@return a robot after this command; the robot itself if the command is about something else}
     *
     * @param robot the robot before this command
     */
    default RobotSpec appliedTo(RobotSpec robot) {
        return robot;
    }

    /**
     * {@return this command, which keeps the switch of a robot's sensor if it changes settings of the sensor} A user
     * who edits settings does not switch the sensor, whatever has switched it in the meantime.
     *
     * @param robot the robot before this command
     */
    default Command keepingSwitch(RobotSpec robot) {
        return this;
    }

    /**
     * A function for each kind of command.
     *
     * @param <R> the type of the results
     * @param switchSensor for a switched sensor
     * @param configureSensor for settings of a sensor
     * @param injectFault for a fault of a sensor
     * @param clearFault for a repair of a sensor
     * @param clearFaults for the repair of all faults of a sensor
     * @param injectMotorFault for a fault of motors
     * @param clearMotorFault for a repair of motors
     * @param clearMotorFaults for the repair of all faults of motors
     * @param moveObstacle for a moved obstacle
     * @param placeObstacle for a new or replaced obstacle
     * @param removeObstacle for a removed obstacle
     * @param setPlatform for settings of the platform
     * @param configureController for settings of the controller
     */
    record CommandCases<R>(
            Function<SwitchSensor, R> switchSensor,
            Function<ConfigureSensor, R> configureSensor,
            Function<InjectFault, R> injectFault,
            Function<ClearFault, R> clearFault,
            Function<ClearFaults, R> clearFaults,
            Function<InjectMotorFault, R> injectMotorFault,
            Function<ClearMotorFault, R> clearMotorFault,
            Function<ClearMotorFaults, R> clearMotorFaults,
            Function<MoveObstacle, R> moveObstacle,
            Function<PlaceObstacle, R> placeObstacle,
            Function<RemoveObstacle, R> removeObstacle,
            Function<SetPlatform, R> setPlatform,
            Function<ConfigureController, R> configureController) {

        /** Made once, because a command is asked often. */
        private static final CommandCases<Boolean> CHANGES_SETUP = ofSetup(
                timed -> false,
                setting -> true,
                setting -> true,
                setting -> true,
                setting -> true,
                setting -> true,
                setting -> true);

        /**
         * {@return functions for the commands that change the setup, and one for all others, which belong to a time of
         * the run: switches of sensors, faults and repairs}
         *
         * @param <R> the type of the results
         * @param timed for a command that belongs to a time of the run
         * @param configureSensor for settings of a sensor
         * @param moveObstacle for a moved obstacle
         * @param placeObstacle for a new or replaced obstacle
         * @param removeObstacle for a removed obstacle
         * @param setPlatform for settings of the platform
         * @param configureController for settings of the controller
         */
        public static <R> CommandCases<R> ofSetup(
                Function<Command, R> timed,
                Function<ConfigureSensor, R> configureSensor,
                Function<MoveObstacle, R> moveObstacle,
                Function<PlaceObstacle, R> placeObstacle,
                Function<RemoveObstacle, R> removeObstacle,
                Function<SetPlatform, R> setPlatform,
                Function<ConfigureController, R> configureController) {
            return new CommandCases<>(
                    timed::apply,
                    configureSensor,
                    timed::apply,
                    timed::apply,
                    timed::apply,
                    timed::apply,
                    timed::apply,
                    timed::apply,
                    moveObstacle,
                    placeObstacle,
                    removeObstacle,
                    setPlatform,
                    configureController);
        }
    }

    /** A command about one sensor. */
    sealed interface SensorCommand extends Command
            permits SwitchSensor, ConfigureSensor, InjectFault, ClearFault, ClearFaults {

        /** {@return the id of the sensor} */
        String sensorId();

        /**
         * {@return the same command about a sensor with another id}
         *
         * @param id the other id
         */
        SensorCommand withSensorId(String id);
    }

    /**
     * Switches a sensor on or off.
     *
     * @param sensor the sensor's id
     * @param on the new state
     */
    record SwitchSensor(String sensor, boolean on) implements SensorCommand {
        @Override
        public String sensorId() {
            return sensor;
        }

        @Override
        public SensorCommand withSensorId(String id) {
            return new SwitchSensor(id, on);
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.switchSensor.apply(this);
        }

        @Override
        public RobotSpec appliedTo(RobotSpec robot) {
            return robot.sensor(sensor)
                    .map(found -> robot.withSensor(found.withOn(on)))
                    .orElse(robot);
        }
    }

    /**
     * Sets a sensor's mounting position, bearing, range, cone, switch and noise.
     *
     * @param sensor the new values; its id names the sensor
     */
    record ConfigureSensor(SensorSpec sensor) implements SensorCommand {
        @Override
        public String sensorId() {
            return sensor.id();
        }

        @Override
        public SensorCommand withSensorId(String id) {
            return new ConfigureSensor(sensor.withId(id));
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.configureSensor.apply(this);
        }

        @Override
        public RobotSpec appliedTo(RobotSpec robot) {
            return robot.indexOf(sensor.id()) < 0 ? robot : robot.withSensor(sensor);
        }

        @Override
        public ConfigureSensor keepingSwitch(RobotSpec robot) {
            return robot.sensor(sensor.id())
                    .map(present -> new ConfigureSensor(sensor.withOn(present.on())))
                    .orElse(this);
        }
    }

    /**
     * Adds a fault to a sensor.
     *
     * @param sensor the sensor's id
     * @param fault the fault, which acts after those that the sensor already has
     */
    record InjectFault(String sensor, Fault fault) implements SensorCommand {
        @Override
        public String sensorId() {
            return sensor;
        }

        @Override
        public SensorCommand withSensorId(String id) {
            return new InjectFault(id, fault);
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.injectFault.apply(this);
        }
    }

    /**
     * Removes one fault from a sensor.
     *
     * @param sensor the sensor's id
     * @param fault the fault; the oldest one equal to it is removed
     */
    record ClearFault(String sensor, Fault fault) implements SensorCommand {
        @Override
        public String sensorId() {
            return sensor;
        }

        @Override
        public SensorCommand withSensorId(String id) {
            return new ClearFault(id, fault);
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.clearFault.apply(this);
        }
    }

    /**
     * Removes all faults from a sensor.
     *
     * @param sensor the sensor's id
     */
    record ClearFaults(String sensor) implements SensorCommand {
        @Override
        public String sensorId() {
            return sensor;
        }

        @Override
        public SensorCommand withSensorId(String id) {
            return new ClearFaults(id);
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.clearFaults.apply(this);
        }
    }

    /**
     * Adds a fault to the motors of a side.
     *
     * @param motor the side
     * @param fault the fault, which acts after those that the side already has
     */
    record InjectMotorFault(MotorSide motor, MotorFault fault) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.injectMotorFault.apply(this);
        }
    }

    /**
     * Removes one fault from the motors of a side.
     *
     * @param motor the side
     * @param fault the fault; the oldest one equal to it is removed
     */
    record ClearMotorFault(MotorSide motor, MotorFault fault) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.clearMotorFault.apply(this);
        }
    }

    /**
     * Removes all faults from the motors of a side.
     *
     * @param motor the side
     */
    record ClearMotorFaults(MotorSide motor) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.clearMotorFaults.apply(this);
        }
    }

    /**
     * Moves an obstacle: it is rotated where it stands, and then moved. If its new pose overlaps the robot, the
     * obstacle slides there along a straight line and stops at first contact, which counts as a collision; a new pose
     * that is free is reached even if the robot is in between. Refused if the obstacle overlaps the robot when it is
     * rotated, or if rounding hides where it touches the robot, which may be so for a side of a kilometre that slides
     * along it.
     *
     * @param obstacle the obstacle's id
     * @param pose the new pose
     */
    record MoveObstacle(String obstacle, Pose pose) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.moveObstacle.apply(this);
        }
    }

    /**
     * Adds an obstacle, or replaces the one with the same id. It may touch the robot.
     *
     * @param obstacle the obstacle
     */
    record PlaceObstacle(Obstacle obstacle) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.placeObstacle.apply(this);
        }
    }

    /**
     * Removes an obstacle.
     *
     * @param obstacle the obstacle's id
     */
    record RemoveObstacle(String obstacle) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.removeObstacle.apply(this);
        }
    }

    /**
     * Changes the robot's platform and linear velocity.
     *
     * @param length metres
     * @param width metres
     * @param speed metres per second
     */
    record SetPlatform(double length, double width, double speed) implements Command {
        /**
         * Creates the command.
         *
         * @param length metres
         * @param width metres
         * @param speed metres per second
         * @throws IllegalArgumentException if a value is not positive and finite
         */
        public SetPlatform {
            RobotSpec.DEFAULT.withPlatform(length, width, speed);
        }

        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.setPlatform.apply(this);
        }

        @Override
        public RobotSpec appliedTo(RobotSpec robot) {
            return robot.withPlatform(length, width, speed);
        }
    }

    /**
     * Changes the controller or its settings. A wall follower continues from its state unless its hand, its period or
     * its diagnosis changes; any other controller starts in its initial state.
     *
     * @param controller the new settings
     */
    record ConfigureController(ControllerSpec.BuiltIn controller) implements Command {
        @Override
        public <R> R match(CommandCases<R> cases) {
            return cases.configureController.apply(this);
        }
    }
}
