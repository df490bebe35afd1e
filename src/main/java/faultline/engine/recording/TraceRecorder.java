package faultline.engine.recording;

import java.util.ArrayList;
import java.util.List;

/**
 * Records all channels tick by tick, at full resolution for recent ticks and at lower resolutions for older ones. Takes
 * at most about 26 MB with eight sensors, and 65 MB with any number: with more than 29 sensors, less is kept.
 */
final class TraceRecorder {

    /** The ratio of the ticks of a bucket to those of a bucket of the next finer level. */
    static final int FACTOR = 4;

    /** The number of levels. The coarsest, with 4096 ticks per bucket, reaches back 67 million ticks. */
    private static final int LEVEL_COUNT = 7;

    /** The number of chunks of single ticks that are kept: 32 768 ticks, five minutes at 10 ms. */
    private static final int MAX_FINEST_CHUNKS = 8;

    /** The number of chunks of each other level that are kept: 16 384 buckets, several for each pixel of any screen. */
    private static final int MAX_COARSE_CHUNKS = 4;

    private final List<TraceLevelRecorder> levels = new ArrayList<>();

    /** Creates an empty recording of some channels. */
    TraceRecorder(int channels) {
        levels.add(new TraceLevelRecorder(channels, 1, 1, MAX_FINEST_CHUNKS));
        for (int ticks = FACTOR; levels.size() < LEVEL_COUNT; ticks *= FACTOR) {
            levels.add(new TraceLevelRecorder(channels, ticks, FACTOR, MAX_COARSE_CHUNKS));
        }
    }

    /**
     * Records the next tick.
     *
     * @param values the values of all channels; copied
     */
    void add(float[] values) {
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

    /** Returns an immutable view of everything recorded so far. */
    Trace view() {
        return new Trace(levels.stream().map(TraceLevelRecorder::view).toList());
    }
}
