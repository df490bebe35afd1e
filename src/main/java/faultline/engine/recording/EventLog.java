package faultline.engine.recording;

import java.util.List;

/**
 * The events of a run in their order, as a view on a recording that goes on. They are counted from the run's first; the
 * oldest may be forgotten.
 */
public final class EventLog {

    /** Of a run that is not recorded. */
    public static final EventLog EMPTY = new EventRecorder().view();

    private final List<RunEvent[]> chunks;
    private final long firstIndex;
    private final long endIndex;

    EventLog(List<RunEvent[]> chunks, long first, long end) {
        this.chunks = chunks;
        this.firstIndex = first;
        this.endIndex = end;
    }

    /**
     * The oldest event that is kept.
     *
     * @return how many have been forgotten
     */
    public long firstIndex() {
        return firstIndex;
    }

    /**
     * The event after the newest.
     *
     * @return how many there have been
     */
    public long endIndex() {
        return endIndex;
    }

    /**
     * One event.
     *
     * @param index from {@link #firstIndex}, below {@link #endIndex}
     * @return the event
     */
    public RunEvent get(long index) {
        if (index < firstIndex || index >= endIndex) {
            throw new IndexOutOfBoundsException("event " + index + " is not in [" + firstIndex + ", " + endIndex + ")");
        }
        return chunks.get((int) ((index - firstIndex) / EventRecorder.CHUNK_SIZE))[
                (int) (index % EventRecorder.CHUNK_SIZE)];
    }

    /**
     * The first kept event of a tick or a later one.
     *
     * @param tick the tick
     * @return its index; {@link #endIndex} where there is none
     */
    public long firstIndexSince(long tick) {
        long low = firstIndex;
        long high = endIndex;
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
