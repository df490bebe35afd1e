package faultline.engine.record;

import java.util.ArrayList;
import java.util.List;

/** Records all channels tick by tick, at full resolution for a while and ever coarser farther back. Some 23 MB with eight sensors at most. */
public final class TraceRecorder {

    /** Each level's buckets have so many times the ticks of the level below. */
    static final int FACTOR = 16;

    /** The coarsest level, of 4096 ticks a bucket, reaches back 134 million ticks. */
    private static final int LEVELS = 4;

    private final List<LevelRecorder> levels = new ArrayList<>();

    /**
     * An empty recording.
     *
     * @param channels how many numbers each tick has
     */
    public TraceRecorder(int channels) {
        int ticksPerBucket = 1;
        for (int i = 0; i < LEVELS; i++) {
            levels.add(new LevelRecorder(channels, ticksPerBucket));
            ticksPerBucket *= FACTOR;
        }
    }

    /**
     * Records the next tick.
     *
     * @param values of all channels; copied
     */
    public void add(float[] values) {
        for (int i = 0; i < LEVELS; i++) {
            levels.get(i).add(values);
        }
    }

    /**
     * All that is recorded by now.
     *
     * @return a view that stays as it is
     */
    public Trace view() {
        return new Trace(levels.stream().map(LevelRecorder::view).toList());
    }
}
