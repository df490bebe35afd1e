package faultline.engine.recording;

/**
 * Records all channels at one resolution: of each bucket of ticks the least and the greatest finite value. Keeps the
 * newest buckets.
 */
final class TraceLevelRecorder {

    /** How many buckets one chunk holds. */
    static final int CHUNK_SIZE = 4096;

    /**
     * The values of some buckets, bucket by bucket.
     *
     * @param min the least of each channel
     * @param max the greatest of each channel; the same array where a bucket is one tick
     */
    record Chunk(float[] min, float[] max) {}

    private final int channels;
    private final int ticksPerBucket;
    private final ChunkList<Chunk> chunks;
    private final int mergeFactor;
    private final float[] min;
    private final float[] max;
    private int mergedCount;
    private long size;

    /**
     * An empty level.
     *
     * @param channels how many numbers a tick has
     * @param ticksPerBucket of this level
     * @param parts how many buckets of the next finer level make one of this
     * @param kept how many chunks are kept
     */
    TraceLevelRecorder(int channels, int ticksPerBucket, int parts, int kept) {
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.mergeFactor = parts;
        chunks = new ChunkList<>(kept);
        min = new float[channels];
        max = new float[channels];
    }

    /**
     * Takes a bucket of the next finer level; true where a bucket of this level is complete with it, which is
     * {@link #min} and {@link #max} then.
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

    /** A bucket spans what is finite in it, and is not a number where nothing is. */
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
        int at = (int) (size % CHUNK_SIZE);
        if (at == 0) {
            chunks.add(newChunk());
        }
        Chunk chunk = chunks.newest();
        System.arraycopy(min, 0, chunk.min, at * channels, channels);
        if (chunk.max != chunk.min) {
            System.arraycopy(max, 0, chunk.max, at * channels, channels);
        }
        size++;
    }

    private Chunk newChunk() {
        float[] lows = new float[CHUNK_SIZE * channels];
        return new Chunk(lows, ticksPerBucket == 1 ? lows : new float[CHUNK_SIZE * channels]);
    }

    TraceLevel view() {
        return new TraceLevel(chunks.chunks(), channels, ticksPerBucket, chunks.dropped() * CHUNK_SIZE, size);
    }
}
