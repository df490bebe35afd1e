package faultline.engine.recording;

import faultline.engine.ChunkLog;
import java.util.Arrays;
import java.util.OptionalLong;

/** The trajectory hash after each tick of a run up to one moment. */
public final class HashTrace {

    /** The hashes of a run that is not recorded. */
    public static final HashTrace EMPTY = new HashTraceRecorder().view();

    private final ChunkLog.View<long[]> hashes;

    HashTrace(ChunkLog.View<long[]> hashes) {
        this.hashes = hashes;
    }

    /** {@return the number of recorded ticks, tick 0 included} */
    public int size() {
        return (int) hashes.end();
    }

    /**
     * {@return the hash after a tick} The hashes of two runs are equal as long as the runs are equal to the bit.
     *
     * @param tick not negative, less than {@link #size}
     */
    public long hashAt(long tick) {
        return hashes.chunk(tick)[hashes.offset(tick)];
    }

    /**
     * {@return whether this trace begins with all hashes of an earlier, non-empty trace of the same run}
     *
     * @param earlier the earlier trace
     */
    public boolean isContinuationOf(HashTrace earlier) {
        return hashes.isContinuationOf(earlier.hashes);
    }

    /**
     * {@return the first tick in which two runs differ, if both are recorded up to there}
     *
     * @param other the trace of the other run
     * @param from a tick before which the runs are known to be equal
     */
    public OptionalLong firstDifference(HashTrace other, int from) {
        int end = Math.min(size(), other.size());
        int tick = from;
        while (tick < end) {
            int start = hashes.offset(tick);
            int stop = Math.min(hashes.chunkSize(), start + end - tick);
            int difference = Arrays.mismatch(hashes.chunk(tick), start, stop, other.hashes.chunk(tick), start, stop);
            if (difference >= 0) {
                return OptionalLong.of(tick + difference);
            }
            tick += stop - start;
        }
        return OptionalLong.empty();
    }
}
