package faultline.engine.recording;

import faultline.engine.ChunkLog;

/** Records the trajectory hash after every tick, so that two runs can be compared tick by tick. */
public final class HashTraceRecorder {

    /** The largest number of hashes that are recorded: 8 MB, almost three hours at 10 ms. */
    public static final int MAX_HASHES = 1 << 20;

    /** The number of hashes in a chunk. */
    static final int CHUNK_SIZE = 1 << 13;

    private final ChunkLog<long[]> log =
            new ChunkLog<>(CHUNK_SIZE, MAX_HASHES / CHUNK_SIZE, () -> new long[CHUNK_SIZE]);
    private int size;

    HashTraceRecorder() {}

    /**
     * Records the hash of the next tick, from tick 0 on. Does nothing after {@link #MAX_HASHES} ticks.
     *
     * @param hash the {@link faultline.engine.Simulation#trajectoryHash}
     */
    public void add(long hash) {
        if (size < MAX_HASHES) {
            int offset = log.append();
            log.newest()[offset] = hash;
            size++;
        }
    }

    /** {@return the hashes recorded so far} */
    public HashTrace view() {
        return new HashTrace(log.view());
    }
}
