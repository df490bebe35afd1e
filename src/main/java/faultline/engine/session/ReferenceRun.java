package faultline.engine.session;

import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RobotPath;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.metrics.RunMeter;
import faultline.engine.recording.HashTrace;
import faultline.engine.recording.HashTraceRecorder;
import faultline.engine.recording.Recorder;
import faultline.engine.recording.Recording;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Collision;
import faultline.world.CommandResult;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.LongPredicate;

/**
 * An earlier run to compare a later one with: the robot's pose and the hash at every tick, and the recording. It is
 * created by repeating the run, which gives the same bits.
 */
public final class ReferenceRun {

    private final SimulationSetup setup;
    private final double[] x;
    private final double[] y;
    private final double[] heading;
    /** The robot from each tick on in which its settings change. */
    private final NavigableMap<Long, RobotSpec> robots = new TreeMap<>();

    private final Recording recording;
    private final RobotPath path;
    private final RunMeasures measures;
    /** Null if there was none. */
    private final Collision firstCollision;

    /** Null if there was none. */
    private final CommandResult.Refused firstRefusal;

    private final int refusalCount;

    private ReferenceRun(Journal journal, Simulation simulation, RefusalCounter counter, LongPredicate shouldContinue) {
        int size = (int) Math.min(journal.ticks() + 1, HashTraceRecorder.MAX_HASHES);
        setup = journal.setup();
        x = new double[size];
        y = new double[size];
        heading = new double[size];
        Recorder recorder = new Recorder(journal.setup());
        RunMeter meter = new RunMeter(journal.setup());
        JournalPlayer replay = new JournalPlayer(journal);
        record(simulation, recorder, meter);
        throwUnless(shouldContinue, simulation.ticks());
        while (simulation.ticks() < size - 1) {
            replay.tick(simulation);
            record(simulation, recorder, meter);
            throwUnless(shouldContinue, simulation.ticks());
        }
        recording = recorder.view();
        path = simulation.frame().path();
        measures = meter.measures();
        firstRefusal = counter.first;
        refusalCount = counter.count;
        firstCollision = simulation.collision().orElse(null);
    }

    /**
     * {@return the repeated run of a journal, at full speed, up to its end, or until it has
     * {@link HashTraceRecorder#MAX_HASHES} hashes}
     *
     * @param journal the journal of the earlier run
     * @param shouldContinue called with 0 and after each tick with its number; false cancels the run
     * @throws RunFailedException if the controller threw an exception
     * @throws CancellationException if the run was cancelled
     */
    public static ReferenceRun replay(Journal journal, LongPredicate shouldContinue) {
        RefusalCounter counter = new RefusalCounter();
        try (Simulation simulation = new Simulation(journal.setup(), ControllerMode.DIRECT, counter)) {
            return new ReferenceRun(journal, simulation, counter, shouldContinue);
        }
    }

    /** Counts the refused commands and keeps the first one; a long run may have many. */
    private static final class RefusalCounter implements CommandListener {

        /** Null if there was none. */
        private CommandResult.Refused first;

        private int count;

        @Override
        public void commandHandled(CommandResult result) {
            if (result instanceof CommandResult.Refused refusal) {
                first = first == null ? refusal : first;
                count++;
            }
        }
    }

    private static void throwUnless(LongPredicate shouldContinue, long tick) {
        if (!shouldContinue.test(tick)) {
            throw new CancellationException("given up at tick " + tick);
        }
    }

    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    private void record(Simulation simulation, Recorder recorder, RunMeter meter) {
        int tick = (int) simulation.ticks();
        Pose pose = simulation.pose();
        x[tick] = pose.x();
        y[tick] = pose.y();
        heading[tick] = pose.heading();
        if (tick == 0 || simulation.robot() != robots.lastEntry().getValue()) {
            robots.put(simulation.ticks(), simulation.robot());
        }
        recorder.observe(simulation);
        meter.observe(simulation);
    }

    /** {@return the setup of the run} */
    public SimulationSetup setup() {
        return setup;
    }

    /** {@return the last tick that is recorded} */
    public long lastTick() {
        return x.length - 1;
    }

    /**
     * {@return the robot's pose at a tick; after the last tick, the pose at the last} Its heading is not normalised.
     *
     * @param tick the tick
     */
    public Pose pose(long tick) {
        int index = (int) Math.min(tick, lastTick());
        return new Pose(x[index], y[index], heading[index]);
    }

    /**
     * {@return the robot with its settings at a tick; after the last tick, those at the last}
     *
     * @param tick the tick, not negative
     */
    public RobotSpec robot(long tick) {
        return robots.floorEntry(tick).getValue();
    }

    /** {@return the robot's whole path} */
    public RobotPath path() {
        return path;
    }

    /** {@return the measures of the run at its end} */
    public RunMeasures measures() {
        return measures;
    }

    /** {@return the first collision of the run, if there was one} */
    public Optional<Collision> collision() {
        return Optional.ofNullable(firstCollision);
    }

    /** {@return the first command that was refused, if one was} */
    public Optional<CommandResult.Refused> firstRefusal() {
        return Optional.ofNullable(firstRefusal);
    }

    /** {@return the number of commands that were refused} */
    public int refusalCount() {
        return refusalCount;
    }

    /** {@return the hash of the trajectory after every tick up to {@link #lastTick}} */
    public HashTrace hashTrace() {
        return recording.hashTrace();
    }

    /** {@return the recording of the run, without its events of commands} */
    public Recording recording() {
        return recording;
    }
}
