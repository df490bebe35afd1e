package faultline.engine.recording;

import java.util.Arrays;

/**
 * Records the trajectory's hash after every tick, so that two runs can be compared tick by tick. Written by one thread;
 * the views that it gives are for all, because a hash once written is never changed.
 */
public final class HashTraceRecorder {

    /** No more are recorded: 8 MB, and almost three hours at 10 ms. */
    public static final int MAX_HASHES = 1 << 20;

    /** How many hashes one chunk holds. */
    static final int CHUNK_SIZE = 1 << 13;

    private long[][] chunks = new long[0][];
    private int size;

    /**
     * Records the hash of the next tick, from tick 0 on; beyond {@link #MAX_HASHES} nothing happens.
     *
     * @param hash as {@link faultline.engine.Simulation#trajectoryHash}
     */
    public void add(long hash) {
        if (size == MAX_HASHES) {
            return;
        }
        int chunk = size / CHUNK_SIZE;
        if (chunk == chunks.length) {
            chunks = Arrays.copyOf(chunks, chunk + 1);
            chunks[chunk] = new long[CHUNK_SIZE];
        }
        chunks[chunk][size % CHUNK_SIZE] = hash;
        size++;
    }

    /**
     * All that is recorded by now.
     *
     * @return a view that stays as it is
     */
    public HashTrace view() {
        return new HashTrace(chunks, size);
    }
}
