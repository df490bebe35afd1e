package faultline.engine.record;

import java.util.Arrays;

/** Records all channels at one resolution: of each bucket of ticks the least and the greatest value. Keeps the newest buckets. */
final class LevelRecorder {

    /** How many buckets one chunk holds. */
    static final int CHUNK = 4096;

    /** How many chunks are kept: 32 768 buckets. */
    private static final int KEPT = 8;

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
    private final ChunkList<Chunk> chunks = new ChunkList<>(KEPT);
    private final float[] low;
    private final float[] high;
    private int gathered;
    private long size;

    LevelRecorder(int channels, int ticksPerBucket) {
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.low = new float[channels];
        this.high = new float[channels];
        empty();
    }

    private void empty() {
        Arrays.fill(low, Float.NaN);
        Arrays.fill(high, Float.NaN);
        gathered = 0;
    }

    /** Records the values of one tick. */
    void add(float[] values) {
        if (ticksPerBucket == 1) {
            close(values, values);
            return;
        }
        for (int i = 0; i < channels; i++) {
            gather(i, values[i]);
        }
        if (++gathered == ticksPerBucket) {
            close(low, high);
            empty();
        }
    }

    /** A bucket spans what is finite in it; comparisons with the not-a-number of an empty one fail, hence their sense. */
    private void gather(int channel, float value) {
        if (Float.isFinite(value)) {
            low[channel] = low[channel] <= value ? low[channel] : value;
            high[channel] = high[channel] >= value ? high[channel] : value;
        }
    }

    private void close(float[] least, float[] greatest) {
        int at = (int) (size % CHUNK);
        if (at == 0) {
            chunks.add(fresh());
        }
        Chunk chunk = chunks.newest();
        System.arraycopy(least, 0, chunk.low, at * channels, channels);
        if (chunk.high != chunk.low) {
            System.arraycopy(greatest, 0, chunk.high, at * channels, channels);
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
