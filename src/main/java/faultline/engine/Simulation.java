package faultline.engine;

import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.geometry.Pose;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Snapshot;
import faultline.world.World;
import java.util.Optional;

/**
 * One run, tick by tick. It belongs to one thread, and holds no clock, sleep or thread of its own making but the
 * controller's link.
 *
 * <p>The decision on observation k-1 acts at tick k, by rule, wherever the controller runs; that, and nothing else, is
 * why both modes give the same bits.
 */
public final class Simulation implements AutoCloseable {

    private final SimulationSetup setup;
    private final World world;
    private final ControllerHost controllerHost;
    private final TickCommands tickCommands;
    private final TrajectoryRecorder trajectoryRecorder = new TrajectoryRecorder();
    private Decision activeDecision;

    /**
     * A run at tick 0: its timeline's first commands applied, its sensors read, its controller asked.
     *
     * @param setup what to run
     * @param mode where the controller runs
     */
    public Simulation(SimulationSetup setup, ControllerMode mode) {
        this(setup, mode, CommandListener.NONE);
    }

    public Simulation(SimulationSetup setup, ControllerMode mode, CommandListener listener) {
        this.setup = setup;
        this.world = new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
        this.controllerHost = ControllerHost.create(ControllerFactory.create(setup.controller()), mode);
        this.activeDecision = new Decision(0, 0, Telemetry.ofState(ControllerFactory.initialState(setup.controller())));
        this.tickCommands = new TickCommands(setup, world, listener);
        senseAndSubmit();
    }

    /**
     * Makes one tick, in the one order that the whole program agrees on.
     *
     * @throws RunFailedException if the controller threw or does not answer
     */
    public void tick() {
        tickCommands.applyDueCommands();
        activeDecision = controllerHost.await();
        world.move(activeDecision.leftVolts(), activeDecision.rightVolts());
        senseAndSubmit();
        tickCommands.endTick();
    }

    /** Steps 6 and 7: sense, record, and ask the controller. */
    private void senseAndSubmit() {
        world.sense();
        trajectoryRecorder.record(world);
        controllerHost.submit(new Observation(world.tick(), setup.dt(), world.robot(), world.reportedReadings()));
    }

    /**
     * Executes a command from outside at the start of the coming tick, and adds it to the journal unless it is refused.
     *
     * @param command the command
     * @return the result
     */
    public CommandResult execute(Command command) {
        return tickCommands.execute(command);
    }

    /**
     * Reads the sensors again, so that a frame taken between two ticks shows what commands have changed. The run itself
     * does not notice.
     */
    public void resample() {
        world.sense();
    }

    /**
     * How many ticks have passed.
     *
     * @return from 0
     */
    public long ticks() {
        return world.tick();
    }

    /**
     * The time that has passed.
     *
     * @return ticks times dt, seconds
     */
    public double time() {
        return world.tick() * setup.dt();
    }

    /**
     * What is run.
     *
     * @return the setup
     */
    public SimulationSetup setup() {
        return setup;
    }

    /**
     * The robot's pose.
     *
     * @return its heading is not normalised
     */
    public Pose pose() {
        return world.pose();
    }

    /**
     * The robot as it is built and set now.
     *
     * @return a value
     */
    public RobotSpec robot() {
        return world.robot();
    }

    /**
     * The speed of the left wheels.
     *
     * @return metres per second
     */
    public double leftSpeed() {
        return world.leftSpeed();
    }

    /**
     * The speed of the right wheels.
     *
     * @return metres per second
     */
    public double rightSpeed() {
        return world.rightSpeed();
    }

    /**
     * The robot's linear velocity.
     *
     * @return metres per second, positive ahead
     */
    public double v() {
        return DifferentialDrive.linearVelocity(world.leftSpeed(), world.rightSpeed());
    }

    /**
     * The robot's angular velocity.
     *
     * @return radians per second, positive to the left
     */
    public double omega() {
        return DifferentialDrive.angularVelocity(
                world.leftSpeed(), world.rightSpeed(), world.robot().track());
    }

    /**
     * What a sensor would read without noise and faults, switched on or not.
     *
     * @param sensor its place in the robot's list
     * @return encoded as in {@link faultline.sensor.Reading}
     */
    public double trueReading(int sensor) {
        return world.trueReading(sensor);
    }

    /**
     * What a sensor reports.
     *
     * @param sensor its place in the robot's list
     * @return encoded as in {@link faultline.sensor.Reading}
     */
    public double reportedReading(int sensor) {
        return world.reportedReading(sensor);
    }

    /**
     * What the controller showed with the decision that acted in the last tick.
     *
     * @return at tick 0 its first state
     */
    public Telemetry telemetry() {
        return activeDecision.telemetry();
    }

    /**
     * What the controller gave the left motors in the last tick.
     *
     * @return volts
     */
    public double leftVolts() {
        return activeDecision.leftVolts();
    }

    /**
     * What the controller gave the right motors in the last tick.
     *
     * @return volts
     */
    public double rightVolts() {
        return activeDecision.rightVolts();
    }

    /**
     * The robot's first contact.
     *
     * @return empty before it
     */
    public Optional<Collision> collision() {
        return world.collision();
    }

    /**
     * The hash over all ticks so far.
     *
     * @return of poses, wheel speeds and reported readings
     */
    public long trajectoryHash() {
        return trajectoryRecorder.hash();
    }

    /**
     * The world now.
     *
     * @return an immutable value
     */
    public Snapshot snapshot() {
        return world.snapshot();
    }

    /**
     * All that is shown of this moment.
     *
     * @return an immutable value
     */
    public Frame frame() {
        return new Frame(
                world.snapshot(), telemetry(), leftVolts(), rightVolts(), trajectoryRecorder.path(), trajectoryHash());
    }

    /**
     * What was done from outside so far.
     *
     * @return an immutable value
     */
    public Journal journal() {
        return tickCommands.journal();
    }

    @Override
    public void close() {
        controllerHost.close();
    }
}
