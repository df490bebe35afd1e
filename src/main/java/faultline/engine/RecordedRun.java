package faultline.engine;

import faultline.geometry.Pose;
import java.util.Arrays;
import java.util.OptionalLong;

/**
 * An earlier run, to be shown beside a later one: where the robot was at every tick, and how the two first differ. Made by running it again, which gives the
 * same bits.
 */
public final class RecordedRun {

    /** No more ticks than this are recorded: 34 MB, and almost three hours at 10 ms. */
    public static final int MOST_TICKS = 1 << 20;

    private final double[] x;
    private final double[] y;
    private final double[] heading;
    private final long[] hashes;
    private final Path path;

    private RecordedRun(Journal journal, Simulation simulation) {
        int size = (int) Math.min(journal.ticks(), MOST_TICKS) + 1;
        x = new double[size];
        y = new double[size];
        heading = new double[size];
        hashes = new long[size];
        Replay replay = new Replay(journal);
        record(simulation);
        while (simulation.ticks() < size - 1) {
            replay.tick(simulation);
            record(simulation);
        }
        path = simulation.frame().path();
    }

    /**
     * Runs a journal again, at full speed.
     *
     * @param journal of the earlier run
     * @return the run up to where the journal ends, or to {@link #MOST_TICKS}
     * @throws RunFailedException if the controller threw
     */
    public static RecordedRun of(Journal journal) {
        try (Simulation simulation = new Simulation(journal.setup(), ControllerMode.DIRECT)) {
            return new RecordedRun(journal, simulation);
        }
    }

    private void record(Simulation simulation) {
        int tick = (int) simulation.ticks();
        Pose pose = simulation.pose();
        x[tick] = pose.x();
        y[tick] = pose.y();
        heading[tick] = pose.heading();
        hashes[tick] = simulation.trajectoryHash();
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
    public Path path() {
        return path;
    }

    /**
     * The trajectory's hash after a tick; equal to another run's at the same tick as long as both are equal to the bit.
     *
     * @param tick from 0 to {@link #lastTick}
     * @return as {@link Frame#trajectoryHash}
     */
    public long hash(long tick) {
        return hashes[(int) tick];
    }

    /**
     * The first tick in which two runs differ by a bit or more of pose, wheel speeds or reported readings.
     *
     * @param other another run
     * @return empty where they do not, as far as both are recorded
     */
    public OptionalLong firstDivergence(RecordedRun other) {
        int common = Math.min(hashes.length, other.hashes.length);
        int first = Arrays.mismatch(hashes, 0, common, other.hashes, 0, common);
        return first < 0 ? OptionalLong.empty() : OptionalLong.of(first);
    }
}
