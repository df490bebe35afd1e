package faultline.engine.recording;

import faultline.engine.ChunkLog;

/**
 * The events of a run up to one moment, in order. They are counted from the first; the oldest may have been dropped.
 */
public final class EventLog {

    /** The log of a run that is not recorded. */
    public static final EventLog EMPTY = new EventRecorder().view();

    private final ChunkLog.View<RunEvent[]> events;

    EventLog(ChunkLog.View<RunEvent[]> events) {
        this.events = events;
    }

    /** {@return the index of the oldest event that is kept, which is also the number of dropped events} */
    public long firstIndex() {
        return events.first();
    }

    /** {@return the index after the newest event} */
    public long endIndex() {
        return events.end();
    }

    /**
     * {@return an event}
     *
     * @param index the index, at least {@link #firstIndex}, less than {@link #endIndex}
     */
    public RunEvent get(long index) {
        return events.chunk(index)[events.offset(index)];
    }

    /**
     * {@return the index of the first kept event at or after a tick, or {@link #endIndex} if there is none}
     *
     * @param tick the tick
     */
    public long firstIndexSince(long tick) {
        long low = firstIndex();
        long high = endIndex();
        while (low < high) {
            long middle = (low + high) >>> 1;
            if (get(middle).tick() < tick) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
