package faultline.engine.session;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RobotPath;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.HashTrace;
import faultline.engine.recording.HashTraceRecorder;
import faultline.geometry.Pose;
import java.util.concurrent.CancellationException;
import java.util.function.LongPredicate;

/**
 * An earlier run, to be shown beside a later one: where the robot was at every tick, and how the two first differ. Made
 * by running it again, which gives the same bits.
 */
public final class ReferenceRun {

    private final SimulationSetup setup;
    private final double[] x;
    private final double[] y;
    private final double[] heading;
    private final HashTrace hashTrace;
    private final RobotPath path;

    private ReferenceRun(Journal journal, Simulation simulation, LongPredicate onward) {
        int size = (int) Math.min(journal.ticks() + 1, HashTraceRecorder.MAX_HASHES);
        setup = journal.setup();
        x = new double[size];
        y = new double[size];
        heading = new double[size];
        HashTraceRecorder recorder = new HashTraceRecorder();
        JournalPlayer replay = new JournalPlayer(journal);
        record(simulation, recorder);
        while (simulation.ticks() < size - 1) {
            if (!onward.test(simulation.ticks())) {
                throw new CancellationException("given up at tick " + simulation.ticks());
            }
            replay.tick(simulation);
            record(simulation, recorder);
        }
        hashTrace = recorder.view();
        path = simulation.frame().path();
    }

    /**
     * Runs a journal again, at full speed.
     *
     * @param journal of the earlier run
     * @return the run up to where the journal ends, or as far as {@link HashTraceRecorder#MAX_HASHES} ticks go
     * @throws RunFailedException if the controller threw
     */
    public static ReferenceRun replay(Journal journal) {
        return replay(journal, tick -> true);
    }

    /**
     * Runs a journal again, at full speed, for as long as that is wanted.
     *
     * @param journal of the earlier run
     * @param onward asked before each tick, on the calling thread, whether to go on; given the tick before
     * @return the run up to where the journal ends, or as far as {@link HashTraceRecorder#MAX_HASHES} ticks go
     * @throws RunFailedException if the controller threw
     * @throws CancellationException if it was not to go on
     */
    public static ReferenceRun replay(Journal journal, LongPredicate onward) {
        try (Simulation simulation = new Simulation(journal.setup(), ControllerMode.DIRECT)) {
            return new ReferenceRun(journal, simulation, onward);
        }
    }

    private void record(Simulation simulation, HashTraceRecorder recorder) {
        int tick = (int) simulation.ticks();
        Pose pose = simulation.pose();
        x[tick] = pose.x();
        y[tick] = pose.y();
        heading[tick] = pose.heading();
        recorder.add(simulation.trajectoryHash());
    }

    /** Returns the setup of the run. */
    public SimulationSetup setup() {
        return setup;
    }

    /**
     * The last tick that is recorded.
     *
     * @return not negative
     */
    public long lastTick() {
        return x.length - 1;
    }

    /**
     * Where the robot was.
     *
     * @param tick the tick; after the last one, the robot stays where it was then
     * @return its heading is not normalised
     */
    public Pose pose(long tick) {
        int index = (int) Math.min(tick, lastTick());
        return new Pose(x[index], y[index], heading[index]);
    }

    /**
     * The robot's path.
     *
     * @return all of it
     */
    public RobotPath path() {
        return path;
    }

    /**
     * The trajectory's hash after every tick; what the run has in common with another shows by them.
     *
     * @return up to {@link #lastTick}
     */
    public HashTrace hashTrace() {
        return hashTrace;
    }
}
