package faultline.engine.recording;

import faultline.engine.ChunkLog;

/**
 * All channels of a run up to one moment at one resolution. A bucket holds the range of each channel over some ticks.
 * Buckets are counted from tick 0; the oldest may have been dropped.
 */
public final class TraceLevel {

    private final ChunkLog.View<TraceLevelRecorder.Chunk> buckets;
    private final int channels;
    private final int ticksPerBucket;

    TraceLevel(ChunkLog.View<TraceLevelRecorder.Chunk> buckets, int channels, int ticksPerBucket) {
        this.buckets = buckets;
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
    }

    /** {@return the number of ticks in a bucket} */
    public int ticksPerBucket() {
        return ticksPerBucket;
    }

    /** {@return the index of the oldest bucket that is kept} */
    public long firstBucket() {
        return buckets.first();
    }

    /** {@return the index after the newest bucket} */
    public long endBucket() {
        return buckets.end();
    }

    /**
     * {@return the least finite value of a channel in a bucket, or NaN if there is none} A bucket of one tick gives the
     * value as it was, even if it is infinite.
     *
     * @param channel see {@link TraceChannels}
     * @param bucket the bucket, at least {@link #firstBucket}, less than {@link #endBucket}
     */
    public float min(int channel, long bucket) {
        return buckets.chunk(bucket).min()[index(channel, bucket)];
    }

    /**
     * {@return the greatest finite value of a channel in a bucket; otherwise as {@link #min}}
     *
     * @param channel see {@link TraceChannels}
     * @param bucket the bucket, at least {@link #firstBucket}, less than {@link #endBucket}
     */
    public float max(int channel, long bucket) {
        return buckets.chunk(bucket).max()[index(channel, bucket)];
    }

    private int index(int channel, long bucket) {
        return buckets.offset(bucket) * channels + channel;
    }
}
