package faultline.world;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;

/**
 * A change to a running world from outside: by a window, a scenario's timeline or a test. A command is a plain value.
 * It is executed at the start of a tick and recorded in the journal with that tick. A command that names something
 * unknown, or that would make an obstacle or a larger platform overlap the robot, is refused and changes nothing (see
 * {@link World#execute}).
 *
 * <p>Code that depends on the kind of command implements {@link Visitor}, so that a new command does not compile until
 * it is handled everywhere.
 */
public sealed interface Command {

    /**
     * {@return the result of the visitor's method for this kind of command}
     *
     * @param visitor the visitor
     * @param <R> the visitor's result type
     */
    <R> R accept(Visitor<R> visitor);

    /**
     * {@return a robot after this command; the robot itself if the command is about something else}
     *
     * @param robot the robot before this command
     */
    default RobotSpec appliedTo(RobotSpec robot) {
        return robot;
    }

    /**
     * An operation with one method for each kind of command.
     *
     * @param <R> the result type
     */
    interface Visitor<R> {
        /**
         * {@return the result for a {@link SwitchSensor}}
         *
         * @param command the command to visit
         */
        R visit(SwitchSensor command);

        /**
         * {@return the result for a {@link ConfigureSensor}}
         *
         * @param command the command to visit
         */
        R visit(ConfigureSensor command);

        /**
         * {@return the result for a {@link InjectFault}}
         *
         * @param command the command to visit
         */
        R visit(InjectFault command);

        /**
         * {@return the result for a {@link ClearFault}}
         *
         * @param command the command to visit
         */
        R visit(ClearFault command);

        /**
         * {@return the result for a {@link ClearFaults}}
         *
         * @param command the command to visit
         */
        R visit(ClearFaults command);

        /**
         * {@return the result for a {@link InjectMotorFault}}
         *
         * @param command the command to visit
         */
        R visit(InjectMotorFault command);

        /**
         * {@return the result for a {@link ClearMotorFault}}
         *
         * @param command the command to visit
         */
        R visit(ClearMotorFault command);

        /**
         * {@return the result for a {@link ClearMotorFaults}}
         *
         * @param command the command to visit
         */
        R visit(ClearMotorFaults command);

        /**
         * {@return the result for a {@link MoveObstacle}}
         *
         * @param command the command to visit
         */
        R visit(MoveObstacle command);

        /**
         * {@return the result for a {@link PlaceObstacle}}
         *
         * @param command the command to visit
         */
        R visit(PlaceObstacle command);

        /**
         * {@return the result for a {@link RemoveObstacle}}
         *
         * @param command the command to visit
         */
        R visit(RemoveObstacle command);

        /**
         * {@return the result for a {@link SetPlatform}}
         *
         * @param command the command to visit
         */
        R visit(SetPlatform command);

        /**
         * {@return the result for a {@link ConfigureController}}
         *
         * @param command the command to visit
         */
        R visit(ConfigureController command);
    }

    /**
     * A visitor of the commands that change the setup. The others, which belong to a time of the run, are visited
     * alike: switches of sensors, faults and repairs.
     *
     * @param <R> the result type
     */
    interface SetupVisitor<R> extends Visitor<R> {

        /**
         * {@return the result for a command that belongs to a time of the run}
         *
         * @param command the command
         */
        R visitTimed(Command command);

        @Override
        default R visit(SwitchSensor command) {
            return visitTimed(command);
        }

        @Override
        default R visit(InjectFault command) {
            return visitTimed(command);
        }

        @Override
        default R visit(ClearFault command) {
            return visitTimed(command);
        }

        @Override
        default R visit(ClearFaults command) {
            return visitTimed(command);
        }

        @Override
        default R visit(InjectMotorFault command) {
            return visitTimed(command);
        }

        @Override
        default R visit(ClearMotorFault command) {
            return visitTimed(command);
        }

        @Override
        default R visit(ClearMotorFaults command) {
            return visitTimed(command);
        }
    }

    /**
     * Switches a sensor on or off.
     *
     * @param sensor the sensor's id
     * @param on the new state
     */
    record SwitchSensor(String sensor, boolean on) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
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
    record ConfigureSensor(SensorSpec sensor) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }

        @Override
        public RobotSpec appliedTo(RobotSpec robot) {
            return robot.indexOf(sensor.id()) < 0 ? robot : robot.withSensor(sensor);
        }
    }

    /**
     * Adds a fault to a sensor.
     *
     * @param sensor the sensor's id
     * @param fault the fault, which acts after those that the sensor already has
     */
    record InjectFault(String sensor, Fault fault) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Removes one fault from a sensor.
     *
     * @param sensor the sensor's id
     * @param fault the fault; the oldest one equal to it is removed
     */
    record ClearFault(String sensor, Fault fault) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Removes all faults from a sensor.
     *
     * @param sensor the sensor's id
     */
    record ClearFaults(String sensor) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
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
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
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
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Removes all faults from the motors of a side.
     *
     * @param motor the side
     */
    record ClearMotorFaults(MotorSide motor) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Moves an obstacle. If its new pose overlaps the robot, the obstacle slides there along a straight line and stops
     * at first contact, which counts as a collision.
     *
     * @param obstacle the obstacle's id
     * @param pose the new pose
     */
    record MoveObstacle(String obstacle, Pose pose) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Adds an obstacle, or replaces the one with the same id.
     *
     * @param obstacle the obstacle
     */
    record PlaceObstacle(Obstacle obstacle) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }

    /**
     * Removes an obstacle.
     *
     * @param obstacle the obstacle's id
     */
    record RemoveObstacle(String obstacle) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
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
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }

        @Override
        public RobotSpec appliedTo(RobotSpec robot) {
            return robot.withPlatform(length, width, speed);
        }
    }

    /**
     * Changes the controller or its settings. A controller of the same kind continues from its state; another one
     * starts in its initial state.
     *
     * @param controller the new settings
     */
    record ConfigureController(ControllerSpec.BuiltIn controller) implements Command {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.visit(this);
        }
    }
}
