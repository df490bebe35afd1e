package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.DecisionLog;
import faultline.control.Telemetry;
import faultline.geometry.Pose;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Fault;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import faultline.world.Snapshot;
import faultline.world.SpatialIndex;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * A run that advances tick by tick. It is confined to one thread and reads no clock; only the controller may run on
 * another thread.
 *
 * <p>The decision on observation k-1 acts at tick k in either controller mode, so both modes give the same bits.
 */
public final class Simulation implements AutoCloseable {

    private final SimulationSetup setup;
    private final World world;
    private final Controller controller;
    private final String controllerName;
    private final ControllerHost controllerHost;
    /** The controller if it was made for this run and is not part of the program, otherwise null. */
    private final Controller foreignController;

    private final DecisionLog decisionLog = new DecisionLog();
    private boolean recordsDecisions;
    private final CommandListener commandListener;
    private final Timeline timeline;
    private final List<Journal.Entry> journal = new ArrayList<>();
    private final VoidCommands voidCommands = new VoidCommands();
    private final TrajectoryRecorder trajectoryRecorder = new TrajectoryRecorder();
    private Decision activeDecision;
    private ControllerSpec controllerSpec;
    /** Null if the controller has its current settings. */
    private ControllerSpec.BuiltIn pendingSettings;
    // Two arrays are used alternately, because a controller may still hold the last observation.
    private double[] readings;
    private double[] previousReadings;
    private RobotSpec trueRobot;
    private RobotSpec believedRobot;

    /**
     * Creates a simulation whose commands have no listener; see {@link #Simulation(SimulationSetup, ControllerMode,
     * CommandListener)}.
     *
     * @param setup the setup
     * @param mode the thread of the controller
     * @throws RunFailedException if the controller cannot be started
     */
    public Simulation(SimulationSetup setup, ControllerMode mode) {
        this(setup, mode, CommandListener.NONE);
    }

    /**
     * Creates a simulation at tick 0: the timeline's commands for time 0 have been executed, the sensors have been
     * read, and the first observation has been submitted to the controller.
     *
     * @param setup the setup
     * @param mode the thread of the controller
     * @param listener receives the result of every command
     * @throws RunFailedException if the controller cannot be started
     */
    public Simulation(SimulationSetup setup, ControllerMode mode, CommandListener listener) {
        this(
                setup,
                () -> ControllerFactory.create(setup),
                ControllerFactory.mode(setup.controller(), mode),
                listener,
                setup.controller() instanceof ControllerSpec.Foreign);
    }

    /**
     * Creates a simulation at tick 0 with a controller instead of the setup's.
     *
     * @param setup the setup. Its controller gives the state of the first telemetry and the first value of
     *     {@link #controllerSpec}. A command may change the settings only if that controller is part of the program
     * @param controller drives the robot; not closed with the simulation
     * @param mode the thread of the controller
     * @param listener receives the result of every command
     */
    public Simulation(SimulationSetup setup, Controller controller, ControllerMode mode, CommandListener listener) {
        this(setup, () -> controller, mode, listener, false);
    }

    private Simulation(
            SimulationSetup setup,
            Supplier<Controller> controllers,
            ControllerMode mode,
            CommandListener listener,
            boolean isForeign) {
        this.setup = setup;
        this.world = new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
        // Made after the world, because nobody would close it if the world could not be made.
        this.controller = controllers.get();
        this.foreignController = isForeign ? controller : null;
        this.recordsDecisions = isForeign;
        this.controllerSpec = setup.controller();
        this.controllerHost = ControllerHost.create(controller, mode);
        this.activeDecision = new Decision(0, 0, Telemetry.ofState(ControllerFactory.initialState(setup.controller())));
        this.commandListener = listener;
        this.readings = new double[setup.robot().sensors().size()];
        this.previousReadings = new double[readings.length];
        this.timeline = new Timeline(setup);
        try {
            // Read before another thread may use the controller.
            this.controllerName = nameOf(controller);
            executeDueCommands(0);
            senseAndSubmit();
        } catch (RuntimeException | Error e) {
            closeAfter(e);
            throw e;
        }
    }

    private static String nameOf(Controller controller) {
        try {
            return Objects.requireNonNull(controller.name(), "name");
        } catch (RuntimeException | Error e) {
            throw RunFailedException.ofController(0, e);
        }
    }

    private void closeAfter(Throwable failure) {
        try {
            close();
        } catch (RunFailedException e) {
            failure.addSuppressed(e);
        }
    }

    /**
     * Advances the run by one tick.
     *
     * @throws RunFailedException if the controller threw an exception or did not answer, or if the robot turns too fast
     *     for its contacts to be found
     */
    public void tick() {
        executeDueCommands(world.tick() + 1);
        activeDecision = controllerHost.await();
        if (recordsDecisions) {
            decisionLog.add(world.tick(), activeDecision);
        }
        move();
        senseAndSubmit();
    }

    private void move() {
        try {
            world.move(activeDecision.leftVolts(), activeDecision.rightVolts());
        } catch (World.UnresolvedContactException unresolved) {
            throw new RunFailedException(
                    RunProblem.UNRESOLVED_CONTACT.with(world.tick() + 1, unresolved.getMessage()), unresolved);
        }
    }

    private void senseAndSubmit() {
        world.sense();
        double[] swapped = previousReadings;
        previousReadings = readings;
        readings = swapped;
        world.copyReportedReadings(readings);
        trajectoryRecorder.record(world, readings, activeDecision.telemetry().state());
        if (pendingSettings != null) {
            // The last decision has been taken and the next one not begun, so the controller is idle.
            controller.configure(pendingSettings);
            pendingSettings = null;
        }
        controllerHost.submit(world.tick(), setup.dt(), believedRobot(), readings);
    }

    /** Returns the robot as the controller believes it to be, the same instance as long as nothing changes. */
    private RobotSpec believedRobot() {
        if (world.robot() != trueRobot) {
            trueRobot = world.robot();
            believedRobot = trueRobot.believed();
        }
        return believedRobot;
    }

    private void executeDueCommands(long tick) {
        while (timeline.isDue(tick)) {
            CommandResult result = executeOnWorld(timeline.take());
            if (!voidCommands.takenFromTimeline(result)) {
                commandListener.commandHandled(result);
            }
        }
    }

    private CommandResult executeOnWorld(Command command) {
        CommandResult result = world.execute(command);
        return command instanceof Command.ConfigureController change ? configure(change, result.tick()) : result;
    }

    /** Changes the settings of the controller; they hold from its next observation. */
    private CommandResult configure(Command.ConfigureController change, long tick) {
        if (controllerSpec instanceof ControllerSpec.BuiltIn before) {
            controllerSpec = change.controller();
            pendingSettings = change.controller();
            return new CommandResult.Executed(tick, change, List.of(new Command.ConfigureController(before)));
        }
        return new CommandResult.Refused(tick, change, new Refusal(Refusal.Reason.FOREIGN_CONTROLLER, ""));
    }

    /**
     * Executes a command from outside at the start of the next tick, after the timeline's commands for that tick, and
     * adds it to the journal unless it is refused.
     *
     * @param command the command
     * @return the inverse of the command, or why it was refused
     */
    public CommandResult execute(Command command) {
        executeDueCommands(world.tick() + 1);
        CommandResult result = executeOnWorld(command);
        commandListener.commandHandled(result);
        if (result.refusal().isEmpty()) {
            journal.add(new Journal.Entry(result.tick(), command));
            voidCommands.executedFromOutside(command);
        }
        return result;
    }

    /**
     * Executes the timeline's commands for the next tick, so that a frame taken before that tick shows their effect
     * after {@link #resample}.
     */
    public void executeDueCommands() {
        executeDueCommands(world.tick() + 1);
    }

    /**
     * Stops recording the path, for a run whose frames are not shown: its ticks then allocate nothing. Frames keep the
     * path recorded before.
     */
    public void stopRecordingPath() {
        trajectoryRecorder.stopRecordingPath();
    }

    /**
     * Stops recording the decisions of a controller that is not part of the program, for a run that is not replayed:
     * they fill the memory if it changes the volts in every tick. {@link #journal} has the decisions made before.
     */
    public void stopRecordingDecisions() {
        recordsDecisions = false;
    }

    /**
     * Reads the sensors again, so that a frame taken between two ticks shows the effect of commands. Later ticks are
     * not affected.
     */
    public void resample() {
        world.resample();
    }

    /** {@return the number of ticks made} */
    public long ticks() {
        return world.tick();
    }

    /** {@return the simulated time: ticks times dt, seconds} */
    public double time() {
        return world.tick() * setup.dt();
    }

    /** {@return the setup of the run} */
    public SimulationSetup setup() {
        return setup;
    }

    /** {@return the robot's pose; its heading is not normalised} */
    public Pose pose() {
        return world.pose();
    }

    /** {@return the robot with its current settings} */
    public RobotSpec robot() {
        return world.robot();
    }

    /** {@return the robot's wheel speeds} */
    public WheelSpeeds wheelSpeeds() {
        return world.wheelSpeeds();
    }

    /**
     * {@return the velocity at which the robot would settle with the present voltages, as the controller believes its
     * motors and track to be}
     */
    public Velocity commandedVelocity() {
        MotorSpec motor = world.robot().motor();
        return new WheelSpeeds(motor.speedFor(leftVolts()), motor.speedFor(rightVolts()))
                .toVelocity(world.robot().track());
    }

    /** {@return the robot's velocity} */
    public Velocity velocity() {
        return world.wheelSpeeds().toVelocity(world.robot().trueTrack());
    }

    /**
     * {@return a sensor's reading without noise and faults, even if it is switched off; encoded as in
     * {@link faultline.sensor.Reading}}
     *
     * @param sensor the sensor's index in the robot's list
     */
    public double trueReading(int sensor) {
        return world.trueReading(sensor);
    }

    /**
     * {@return a sensor's reported reading; encoded as in {@link faultline.sensor.Reading}}
     *
     * @param sensor the sensor's index in the robot's list
     */
    public double reportedReading(int sensor) {
        return world.reportedReading(sensor);
    }

    /** {@return the current settings of the controller} */
    public ControllerSpec controllerSpec() {
        return controllerSpec;
    }

    /** {@return the name that the controller gives itself, on one line; empty if it gives none} */
    public String controllerName() {
        return controllerName;
    }

    /**
     * {@return the active faults of a sensor, oldest first, in an immutable list}
     *
     * @param sensor the sensor's index in the robot's list
     */
    public List<Fault> faults(int sensor) {
        return world.faults(sensor);
    }

    /** {@return the active faults of the motors} */
    public MotorFaults motorFaults() {
        return world.motorFaults();
    }

    /** {@return the telemetry of the decision that acted in the last tick; at tick 0 that of the initial state} */
    public Telemetry telemetry() {
        return activeDecision.telemetry();
    }

    /** {@return the voltage of the left motors in the last tick, volts} */
    public double leftVolts() {
        return activeDecision.leftVolts();
    }

    /** {@return the voltage of the right motors in the last tick, volts} */
    public double rightVolts() {
        return activeDecision.rightVolts();
    }

    /** {@return the robot's first collision, if there was one} */
    public Optional<Collision> collision() {
        return world.collision();
    }

    /** {@return the hash over the poses, wheel speeds and reported readings of all ticks so far} */
    public long trajectoryHash() {
        return trajectoryRecorder.hash();
    }

    /** {@return an index of the static shapes at the start, the enclosing wall first} */
    public SpatialIndex startIndex() {
        return world.startIndex();
    }

    /** {@return the current state of the world} */
    public Snapshot snapshot() {
        return world.snapshot();
    }

    /** {@return the current state of the run} */
    public Frame frame() {
        return new Frame(
                world.snapshot(), telemetry(), leftVolts(), rightVolts(), trajectoryRecorder.path(), trajectoryHash());
    }

    /** {@return the commands executed from outside so far} */
    public Journal journal() {
        return new Journal(setup, journal, world.tick(), decisionLog.decisions());
    }

    /**
     * Ends the thread of the controller, and closes a controller that was made for this run.
     *
     * @throws RunFailedException if the controller throws an exception when it is closed
     */
    @Override
    public void close() {
        controllerHost.close();
        if (foreignController != null) {
            ControllerFactory.close(foreignController, setup.controller());
        }
    }
}
