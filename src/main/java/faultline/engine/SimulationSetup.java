package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.math.BigDecimal;
import java.util.List;
import java.util.Objects;

/**
 * Everything that determines a run: equal setups have equal trajectories, to the bit.
 *
 * @param world the world at the start
 * @param robot the robot
 * @param start the robot's pose at time 0
 * @param controller drives the robot
 * @param timeline the timed commands, in the order of the file
 * @param dt the length of a tick, seconds, positive
 * @param seed the seed of all random numbers
 * @param duration the length of a run, seconds, not negative
 */
public record SimulationSetup(
        WorldSpec world,
        RobotSpec robot,
        Pose start,
        ControllerSpec controller,
        List<TimedCommand> timeline,
        double dt,
        long seed,
        double duration) {

    /** The length of a tick if none is given, seconds. */
    public static final double DEFAULT_TICK = 0.01;

    /** The seed if none is given. */
    public static final long DEFAULT_SEED = 1;

    /** The duration if none is given, seconds. */
    public static final double DEFAULT_DURATION = 120;

    /**
     * Creates a setup.
     *
     * @param world the world at the start
     * @param robot the robot
     * @param start the robot's pose at time 0
     * @param controller drives the robot
     * @param timeline the timed commands, in the order of the file
     * @param dt the length of a tick, seconds, positive
     * @param seed the seed of all random numbers
     * @param duration the length of a run, seconds, not negative
     * @throws IllegalArgumentException if the tick is not positive and finite, or the duration is negative or not
     *     finite
     */
    public SimulationSetup {
        Objects.requireNonNull(world, "world");
        Objects.requireNonNull(robot, "robot");
        Objects.requireNonNull(start, "start");
        Objects.requireNonNull(controller, "controller");
        timeline = List.copyOf(timeline);
        if (!(dt > 0 && Double.isFinite(dt))) {
            throw new IllegalArgumentException("a tick must be positive: " + dt);
        }
        if (!(duration >= 0 && Double.isFinite(duration))) {
            throw new IllegalArgumentException("the duration must not be negative: " + duration);
        }
    }

    /**
     * {@return the setup of the default robot with the default wall follower and an empty timeline}
     *
     * @param world the world
     * @param start the robot's pose at the start
     */
    public static SimulationSetup of(WorldSpec world, Pose start) {
        return new SimulationSetup(
                world,
                RobotSpec.DEFAULT,
                start,
                ControllerSpec.WallFollowing.DEFAULT,
                List.of(),
                DEFAULT_TICK,
                DEFAULT_SEED,
                DEFAULT_DURATION);
    }

    /**
     * A command of the timeline.
     *
     * @param time seconds, not negative
     * @param command the command
     */
    public record TimedCommand(double time, Command command) {
        /**
         * Creates a timed command.
         *
         * @param time seconds, not negative
         * @param command the command
         * @throws IllegalArgumentException if the time is negative or not finite
         */
        public TimedCommand {
            if (!(time >= 0 && Double.isFinite(time))) {
                throw new IllegalArgumentException("a time must not be negative: " + time);
            }
            Objects.requireNonNull(command, "command");
        }
    }

    /**
     * {@return the first tick that is not before a time} A millionth of a tick is tolerated as a rounding error.
     *
     * @param seconds the time, not negative
     */
    public long tickAt(double seconds) {
        return tickAt(seconds, dt);
    }

    /**
     * {@return the first tick that is not before a time} A millionth of a tick is tolerated as a rounding error.
     *
     * @param seconds the time, not negative
     * @param dt the length of a tick, seconds, positive
     */
    public static long tickAt(double seconds, double dt) {
        return (long) Math.ceil(seconds / dt - 1e-6);
    }

    /**
     * {@return the time of a tick, seconds, without a rounding error: 35.91 for tick 3591 of 0.01 s}
     *
     * @param tick the tick
     */
    public double timeOf(long tick) {
        return BigDecimal.valueOf(dt).multiply(BigDecimal.valueOf(tick)).doubleValue();
    }

    /** {@return the number of ticks up to {@link #duration}} */
    public long ticks() {
        return tickAt(duration);
    }

    /**
     * {@return this setup with another world}
     *
     * @param newWorld the new world
     */
    public SimulationSetup withWorld(WorldSpec newWorld) {
        return new SimulationSetup(newWorld, robot, start, controller, timeline, dt, seed, duration);
    }

    /**
     * {@return this setup with another robot}
     *
     * @param newRobot the new robot
     */
    public SimulationSetup withRobot(RobotSpec newRobot) {
        return new SimulationSetup(world, newRobot, start, controller, timeline, dt, seed, duration);
    }

    /**
     * {@return this setup with another start pose}
     *
     * @param pose the new start pose
     */
    public SimulationSetup withStart(Pose pose) {
        return new SimulationSetup(world, robot, pose, controller, timeline, dt, seed, duration);
    }

    /**
     * {@return this setup with another controller}
     *
     * @param newController the new controller
     */
    public SimulationSetup withController(ControllerSpec newController) {
        return new SimulationSetup(world, robot, start, newController, timeline, dt, seed, duration);
    }

    /**
     * {@return this setup with another timeline}
     *
     * @param newTimeline the new commands, in order of execution within a tick
     */
    public SimulationSetup withTimeline(List<TimedCommand> newTimeline) {
        return new SimulationSetup(world, robot, start, controller, newTimeline, dt, seed, duration);
    }

    /**
     * {@return this setup with another length of a tick, seconds, positive}
     *
     * @param seconds the length of a tick, in seconds, positive
     */
    public SimulationSetup withTick(double seconds) {
        return new SimulationSetup(world, robot, start, controller, timeline, seconds, seed, duration);
    }

    /**
     * {@return this setup with another seed}
     *
     * @param newSeed the new seed
     */
    public SimulationSetup withSeed(long newSeed) {
        return new SimulationSetup(world, robot, start, controller, timeline, dt, newSeed, duration);
    }

    /**
     * {@return this setup with another duration, seconds, not negative}
     *
     * @param seconds the duration, in seconds, not negative
     */
    public SimulationSetup withDuration(double seconds) {
        return new SimulationSetup(world, robot, start, controller, timeline, dt, seed, seconds);
    }
}
