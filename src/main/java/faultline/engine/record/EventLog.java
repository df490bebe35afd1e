package faultline.engine.record;

import java.util.List;

/**
 * The events of a run in their order, as a view on a recording that goes on. They are counted from the run's first; the oldest may be
 * forgotten.
 */
public final class EventLog {

    /** Of a run that is not recorded. */
    public static final EventLog EMPTY = new EventRecorder().view();

    private final List<RunEvent[]> chunks;
    private final long first;
    private final long end;

    EventLog(List<RunEvent[]> chunks, long first, long end) {
        this.chunks = chunks;
        this.first = first;
        this.end = end;
    }

    /**
     * The oldest event that is kept.
     *
     * @return how many have been forgotten
     */
    public long first() {
        return first;
    }

    /**
     * The event after the newest.
     *
     * @return how many there have been
     */
    public long end() {
        return end;
    }

    /**
     * One event.
     *
     * @param index from {@link #first}, below {@link #end}
     * @return the event
     */
    public RunEvent get(long index) {
        if (index < first || index >= end) {
            throw new IndexOutOfBoundsException("event " + index + " is not in [" + first + ", " + end + ")");
        }
        return chunks.get((int) ((index - first) / EventRecorder.CHUNK))[(int) (index % EventRecorder.CHUNK)];
    }

    /**
     * The first kept event of a tick or a later one.
     *
     * @param tick the tick
     * @return its index; {@link #end} where there is none
     */
    public long since(long tick) {
        long low = first;
        long high = end;
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
