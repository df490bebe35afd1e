package faultline.engine.recording;

import faultline.engine.ChunkLog;

/** Records the events of a run in order, and keeps at least the newest 7680. */
public final class EventRecorder {

    /** The number of events in a chunk. */
    static final int CHUNK_SIZE = 512;

    private static final int MAX_CHUNKS = 16;

    private final ChunkLog<RunEvent[]> log = new ChunkLog<>(CHUNK_SIZE, MAX_CHUNKS, () -> new RunEvent[CHUNK_SIZE]);

    /** Creates an empty recorder. */
    public EventRecorder() {}

    /**
     * Records an event that is not earlier than the last one.
     *
     * @param event the event
     */
    public void add(RunEvent event) {
        int offset = log.append();
        log.newest()[offset] = event;
    }

    /** {@return the events that are kept} */
    public EventLog view() {
        return new EventLog(log.view());
    }
}
