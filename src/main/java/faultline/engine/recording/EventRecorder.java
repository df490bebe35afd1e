package faultline.engine.recording;

/** Records events in their order; keeps the newest 8192 or a few less. */
public final class EventRecorder {

    /** How many events one chunk holds. */
    static final int CHUNK_SIZE = 512;

    private static final int MAX_CHUNKS = 16;

    private final ChunkList<RunEvent[]> chunks = new ChunkList<>(MAX_CHUNKS);
    private long size;

    /**
     * Records an event.
     *
     * @param event not before the last
     */
    public void add(RunEvent event) {
        int at = (int) (size % CHUNK_SIZE);
        if (at == 0) {
            chunks.add(new RunEvent[CHUNK_SIZE]);
        }
        chunks.newest()[at] = event;
        size++;
    }

    /**
     * All that is kept by now.
     *
     * @return a view that stays as it is
     */
    public EventLog view() {
        return new EventLog(chunks.chunks(), chunks.dropped() * CHUNK_SIZE, size);
    }
}
