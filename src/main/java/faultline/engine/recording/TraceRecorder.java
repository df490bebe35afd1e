package faultline.engine.recording;

import java.util.ArrayList;
import java.util.List;

/**
 * Records all channels tick by tick, at full resolution for a while and ever coarser farther back. Some 21 MB with
 * eight sensors at most.
 */
final class TraceRecorder {

    /** How many times as many ticks a bucket has as one of the next finer level. */
    static final int FACTOR = 4;

    /** The coarsest level, of 4096 ticks a bucket, reaches back 67 million ticks. */
    private static final int LEVEL_COUNT = 7;

    /** How many chunks of single ticks are kept: 32 768 ticks, five minutes at 10 ms. */
    private static final int MAX_FINEST_CHUNKS = 8;

    /** How many chunks of other levels are: 16 384 buckets, some for every pixel of any screen. */
    private static final int MAX_COARSE_CHUNKS = 4;

    private final List<TraceLevelRecorder> levels = new ArrayList<>();

    /**
     * Creates an empty recording.
     *
     * @param channels how many numbers each tick has
     */
    public TraceRecorder(int channels) {
        levels.add(new TraceLevelRecorder(channels, 1, 1, MAX_FINEST_CHUNKS));
        for (int ticks = FACTOR; levels.size() < LEVEL_COUNT; ticks *= FACTOR) {
            levels.add(new TraceLevelRecorder(channels, ticks, FACTOR, MAX_COARSE_CHUNKS));
        }
    }

    /**
     * Records the next tick.
     *
     * @param values of all channels; copied
     */
    public void add(float[] values) {
        float[] low = values;
        float[] high = values;
        for (TraceLevelRecorder level : levels) {
            if (!level.add(low, high)) {
                return;
            }
            low = level.min();
            high = level.max();
        }
    }

    /** {@return a view of everything recorded so far, which stays as it is} */
    public Trace view() {
        return new Trace(levels.stream().map(TraceLevelRecorder::view).toList());
    }
}
