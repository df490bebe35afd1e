package faultline.engine.recording;

import java.util.Arrays;
import java.util.OptionalLong;

/** The trajectory's hash after each tick of a run so far, as a view of fixed length on a recording that goes on. */
public final class HashTrace {

    /** Of a run that is not recorded. */
    public static final HashTrace EMPTY = new HashTraceRecorder().view();

    private final long[][] chunks;
    private final int size;

    HashTrace(long[][] chunks, int size) {
        this.chunks = chunks;
        this.size = size;
    }

    /**
     * How many ticks there are.
     *
     * @return the first tick after them
     */
    public int size() {
        return size;
    }

    /**
     * The hash after a tick.
     *
     * @param tick from 0, below {@link #size}
     * @return equal to another run's as long as both are equal to the bit
     */
    public long hashAt(long tick) {
        return chunks[(int) (tick / HashTraceRecorder.CHUNK_SIZE)][(int) (tick % HashTraceRecorder.CHUNK_SIZE)];
    }

    /**
     * Whether this view continues another: same recording, at least as long.
     *
     * @param earlier another view
     * @return true where the first hashes of this are all of {@code earlier}'s
     */
    public boolean isContinuationOf(HashTrace earlier) {
        return earlier.size > 0 && size >= earlier.size && chunks[0] == earlier.chunks[0];
    }

    /**
     * The first tick in which two runs differ.
     *
     * @param other of another run
     * @param from a tick before which they are known to be equal
     * @return empty where they do not differ, as far as both are recorded
     */
    public OptionalLong firstDifference(HashTrace other, int from) {
        int end = Math.min(size, other.size);
        int tick = from;
        while (tick < end) {
            int start = tick % HashTraceRecorder.CHUNK_SIZE;
            int length = Math.min(HashTraceRecorder.CHUNK_SIZE - start, end - tick);
            int chunk = tick / HashTraceRecorder.CHUNK_SIZE;
            int first =
                    Arrays.mismatch(chunks[chunk], start, start + length, other.chunks[chunk], start, start + length);
            if (first >= 0) {
                return OptionalLong.of(tick + first);
            }
            tick += length;
        }
        return OptionalLong.empty();
    }
}
