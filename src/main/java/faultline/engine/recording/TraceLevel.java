package faultline.engine.recording;

import java.util.List;

/**
 * All channels at one resolution, as a view on a recording that goes on. Buckets are counted from tick 0 on; the oldest
 * may be forgotten.
 */
public final class TraceLevel {

    private final List<TraceLevelRecorder.Chunk> chunks;
    private final int channels;
    private final int ticksPerBucket;
    private final long firstBucket;
    private final long endBucket;

    TraceLevel(List<TraceLevelRecorder.Chunk> chunks, int channels, int ticksPerBucket, long first, long end) {
        this.chunks = chunks;
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.firstBucket = first;
        this.endBucket = end;
    }

    /**
     * How many ticks a bucket has.
     *
     * @return at least 1
     */
    public int ticksPerBucket() {
        return ticksPerBucket;
    }

    /**
     * The oldest bucket that is kept.
     *
     * @return not above {@link #endBucket}
     */
    public long firstBucket() {
        return firstBucket;
    }

    /**
     * The bucket after the newest one.
     *
     * @return how many buckets there have been
     */
    public long endBucket() {
        return endBucket;
    }

    /**
     * The least value of a channel in a bucket.
     *
     * @param channel of {@link TraceChannels}
     * @param bucket from {@link #firstBucket}, below {@link #endBucket}
     * @return not a number where there was none; in buckets of one tick as it was, also positive infinity
     */
    public float min(int channel, long bucket) {
        return chunk(bucket).min()[index(channel, bucket)];
    }

    /**
     * The greatest value of a channel in a bucket.
     *
     * @param channel of {@link TraceChannels}
     * @param bucket from {@link #firstBucket}, below {@link #endBucket}
     * @return not a number where there was none; in buckets of one tick as it was, also positive infinity
     */
    public float max(int channel, long bucket) {
        return chunk(bucket).max()[index(channel, bucket)];
    }

    private TraceLevelRecorder.Chunk chunk(long bucket) {
        if (bucket < firstBucket || bucket >= endBucket) {
            throw new IndexOutOfBoundsException(
                    "bucket " + bucket + " is not in [" + firstBucket + ", " + endBucket + ")");
        }
        return chunks.get((int) ((bucket - firstBucket) / TraceLevelRecorder.CHUNK_SIZE));
    }

    private int index(int channel, long bucket) {
        return (int) (bucket % TraceLevelRecorder.CHUNK_SIZE) * channels + channel;
    }
}
