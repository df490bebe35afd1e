package faultline.engine.record;

/** Records all channels at one resolution: of each bucket of ticks the least and the greatest finite value. Keeps the newest buckets. */
final class LevelRecorder {

    /** How many buckets one chunk holds. */
    static final int CHUNK = 4096;

    /**
     * The values of some buckets, bucket by bucket.
     *
     * @param low the least of each channel
     * @param high the greatest of each channel; the same array where a bucket is one tick
     */
    record Chunk(float[] low, float[] high) {
    }

    private final int channels;
    private final int ticksPerBucket;
    private final ChunkList<Chunk> chunks;
    private final int parts;
    private final float[] low;
    private final float[] high;
    private int gathered;
    private long size;

    /**
     * An empty level.
     *
     * @param channels how many numbers a tick has
     * @param ticksPerBucket of this level
     * @param parts how many buckets of the next finer level make one of this
     * @param kept how many chunks are kept
     */
    LevelRecorder(int channels, int ticksPerBucket, int parts, int kept) {
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.parts = parts;
        chunks = new ChunkList<>(kept);
        low = new float[channels];
        high = new float[channels];
    }

    /**
     * Takes a bucket of the next finer level; true where a bucket of this level is complete with it, which is {@link #low} and {@link
     * #high} then.
     */
    boolean add(float[] least, float[] greatest) {
        if (gathered == 0) {
            System.arraycopy(least, 0, low, 0, channels);
            System.arraycopy(greatest, 0, high, 0, channels);
        }
        if (parts > 1) {
            gather(least, greatest);
        }
        gathered = (gathered + 1) % parts;
        if (gathered == 0) {
            keep();
        }
        return gathered == 0;
    }

    /** A bucket spans what is finite in it, and is not a number where nothing is. */
    private void gather(float[] least, float[] greatest) {
        for (int i = 0; i < channels; i++) {
            low[i] = pick(low[i], least[i], Math.min(low[i], least[i]));
            high[i] = pick(high[i], greatest[i], Math.max(high[i], greatest[i]));
        }
    }

    private static float pick(float one, float other, float ifBoth) {
        if (Float.isFinite(one)) {
            return Float.isFinite(other) ? ifBoth : one;
        }
        return Float.isFinite(other) ? other : Float.NaN;
    }

    float[] low() {
        return low;
    }

    float[] high() {
        return high;
    }

    private void keep() {
        int at = (int) (size % CHUNK);
        if (at == 0) {
            chunks.add(fresh());
        }
        Chunk chunk = chunks.newest();
        System.arraycopy(low, 0, chunk.low, at * channels, channels);
        if (chunk.high != chunk.low) {
            System.arraycopy(high, 0, chunk.high, at * channels, channels);
        }
        size++;
    }

    private Chunk fresh() {
        float[] lows = new float[CHUNK * channels];
        return new Chunk(lows, ticksPerBucket == 1 ? lows : new float[CHUNK * channels]);
    }

    Level view() {
        return new Level(chunks.all(), channels, ticksPerBucket, chunks.dropped() * CHUNK, size);
    }
}
