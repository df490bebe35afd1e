package faultline.engine.record;

import java.util.Arrays;
import java.util.OptionalLong;

/** The trajectory's hash after each tick of a run so far, as a view of fixed length on a recording that goes on. */
public final class Hashes {

    /** Of a run that is not recorded. */
    public static final Hashes EMPTY = new HashRecorder().view();

    private final long[][] chunks;
    private final int size;

    Hashes(long[][] chunks, int size) {
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
    public long at(long tick) {
        return chunks[(int) (tick / HashRecorder.CHUNK)][(int) (tick % HashRecorder.CHUNK)];
    }

    /**
     * Whether this view continues another: same recording, at least as long.
     *
     * @param earlier another view
     * @return true where the first hashes of this are all of {@code earlier}'s
     */
    public boolean continues(Hashes earlier) {
        return earlier.size > 0 && size >= earlier.size && chunks[0] == earlier.chunks[0];
    }

    /**
     * The first tick in which two runs differ.
     *
     * @param other of another run
     * @param from a tick before which they are known to be equal
     * @return empty where they do not differ, as far as both are recorded
     */
    public OptionalLong firstDifference(Hashes other, int from) {
        int end = Math.min(size, other.size);
        int tick = from;
        while (tick < end) {
            int start = tick % HashRecorder.CHUNK;
            int length = Math.min(HashRecorder.CHUNK - start, end - tick);
            int chunk = tick / HashRecorder.CHUNK;
            int first = Arrays.mismatch(chunks[chunk], start, start + length, other.chunks[chunk], start, start + length);
            if (first >= 0) {
                return OptionalLong.of(tick + first);
            }
            tick += length;
        }
        return OptionalLong.empty();
    }
}
