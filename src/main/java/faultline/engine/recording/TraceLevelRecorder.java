package faultline.engine.recording;

import faultline.engine.ChunkLog;

/**
 * Records all channels at one resolution: the least and the greatest finite value in each bucket of ticks. Keeps the
 * newest buckets.
 */
final class TraceLevelRecorder {

    /** The maximum number of buckets in a chunk. */
    private static final int MAX_CHUNK_SIZE = 4096;

    /** The number of channels, those of 29 sensors, with which a chunk has the maximum number of buckets. */
    private static final int MAX_CHANNELS = 70;

    /**
     * The values of consecutive buckets, bucket by bucket.
     *
     * @param min the least value of each channel
     * @param max the greatest value of each channel; the same array as min if a bucket is one tick
     */
    record Chunk(float[] min, float[] max) {}

    private final int channels;
    private final int chunkSize;
    private final int ticksPerBucket;
    private final ChunkLog<Chunk> log;
    private final int mergeFactor;
    private final float[] min;
    private final float[] max;
    private int mergedCount;

    /**
     * Creates an empty level whose buckets each merge {@code mergeFactor} buckets of the next finer level, and of which
     * a number of chunks is kept.
     */
    TraceLevelRecorder(int channels, int ticksPerBucket, int mergeFactor, int maxChunks) {
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.mergeFactor = mergeFactor;
        chunkSize = Math.min(MAX_CHUNK_SIZE, MAX_CHUNK_SIZE * MAX_CHANNELS / Math.max(1, channels));
        log = new ChunkLog<>(chunkSize, maxChunks, this::newChunk);
        min = new float[channels];
        max = new float[channels];
    }

    /**
     * Adds a bucket of the next finer level. Returns true if it completes a bucket of this level, which is then in
     * {@link #min} and {@link #max}.
     */
    boolean add(float[] least, float[] greatest) {
        if (mergedCount == 0) {
            System.arraycopy(least, 0, min, 0, channels);
            System.arraycopy(greatest, 0, max, 0, channels);
        }
        if (mergeFactor > 1) {
            merge(least, greatest);
        }
        mergedCount = (mergedCount + 1) % mergeFactor;
        if (mergedCount == 0) {
            storeBucket();
        }
        return mergedCount == 0;
    }

    /** Extends the range of the bucket by the finite values; a range without any is NaN. */
    private void merge(float[] least, float[] greatest) {
        for (int i = 0; i < channels; i++) {
            min[i] = combine(min[i], least[i], Math.min(min[i], least[i]));
            max[i] = combine(max[i], greatest[i], Math.max(max[i], greatest[i]));
        }
    }

    private static float combine(float one, float other, float ifBoth) {
        if (Float.isFinite(one)) {
            return Float.isFinite(other) ? ifBoth : one;
        }
        return Float.isFinite(other) ? other : Float.NaN;
    }

    float[] min() {
        return min;
    }

    float[] max() {
        return max;
    }

    private void storeBucket() {
        int offset = log.append() * channels;
        Chunk chunk = log.newest();
        System.arraycopy(min, 0, chunk.min, offset, channels);
        if (chunk.max != chunk.min) {
            System.arraycopy(max, 0, chunk.max, offset, channels);
        }
    }

    private Chunk newChunk() {
        float[] lows = new float[chunkSize * channels];
        return new Chunk(lows, ticksPerBucket == 1 ? lows : new float[chunkSize * channels]);
    }

    TraceLevel view() {
        return new TraceLevel(log.view(), channels, ticksPerBucket);
    }
}
