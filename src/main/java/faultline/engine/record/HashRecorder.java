package faultline.engine.record;

import java.util.Arrays;

/**
 * Records the trajectory's hash after every tick, so that two runs can be compared tick by tick. Written by one thread; the views that it
 * gives are for all, because a hash once written is never changed.
 */
public final class HashRecorder {

    /** No more are recorded: 8 MB, and almost three hours at 10 ms. */
    public static final int MOST = 1 << 20;

    /** How many hashes one chunk holds. */
    static final int CHUNK = 1 << 13;

    private long[][] chunks = new long[0][];
    private int size;

    /**
     * Records the hash of the next tick, from tick 0 on; beyond {@link #MOST} nothing happens.
     *
     * @param hash as {@link faultline.engine.Simulation#trajectoryHash}
     */
    public void add(long hash) {
        if (size == MOST) {
            return;
        }
        int chunk = size / CHUNK;
        if (chunk == chunks.length) {
            chunks = Arrays.copyOf(chunks, chunk + 1);
            chunks[chunk] = new long[CHUNK];
        }
        chunks[chunk][size % CHUNK] = hash;
        size++;
    }

    /**
     * All that is recorded by now.
     *
     * @return a view that stays as it is
     */
    public Hashes view() {
        return new Hashes(chunks, size);
    }
}
