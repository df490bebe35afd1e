package faultline.engine.record;

import java.util.List;

/**
 * All channels at one resolution, as a view on a recording that goes on. Buckets are counted from tick 0 on; the oldest may be forgotten.
 */
public final class Level {

    private final List<LevelRecorder.Chunk> chunks;
    private final int channels;
    private final int ticksPerBucket;
    private final long first;
    private final long end;

    Level(List<LevelRecorder.Chunk> chunks, int channels, int ticksPerBucket, long first, long end) {
        this.chunks = chunks;
        this.channels = channels;
        this.ticksPerBucket = ticksPerBucket;
        this.first = first;
        this.end = end;
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
     * @return not above {@link #end}
     */
    public long first() {
        return first;
    }

    /**
     * The bucket after the newest one.
     *
     * @return how many buckets there have been
     */
    public long end() {
        return end;
    }

    /**
     * The least value of a channel in a bucket.
     *
     * @param channel of {@link Channels}
     * @param bucket from {@link #first}, below {@link #end}
     * @return not a number where there was none; in buckets of one tick as it was, also positive infinity
     */
    public float low(int channel, long bucket) {
        return chunk(bucket).low()[index(channel, bucket)];
    }

    /**
     * The greatest value of a channel in a bucket.
     *
     * @param channel of {@link Channels}
     * @param bucket from {@link #first}, below {@link #end}
     * @return not a number where there was none; in buckets of one tick as it was, also positive infinity
     */
    public float high(int channel, long bucket) {
        return chunk(bucket).high()[index(channel, bucket)];
    }

    private LevelRecorder.Chunk chunk(long bucket) {
        if (bucket < first || bucket >= end) {
            throw new IndexOutOfBoundsException("bucket " + bucket + " is not in [" + first + ", " + end + ")");
        }
        return chunks.get((int) ((bucket - first) / LevelRecorder.CHUNK));
    }

    private int index(int channel, long bucket) {
        return (int) (bucket % LevelRecorder.CHUNK) * channels + channel;
    }
}
