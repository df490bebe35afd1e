package faultline.engine.record;

/** Records events in their order; keeps the newest 8192 or a few less. */
public final class EventRecorder {

    /** How many events one chunk holds. */
    static final int CHUNK = 512;

    private static final int KEPT = 16;

    private final ChunkList<RunEvent[]> chunks = new ChunkList<>(KEPT);
    private long size;

    /**
     * Records an event.
     *
     * @param event not before the last
     */
    public void add(RunEvent event) {
        int at = (int) (size % CHUNK);
        if (at == 0) {
            chunks.add(new RunEvent[CHUNK]);
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
        return new EventLog(chunks.all(), chunks.dropped() * CHUNK, size);
    }
}
