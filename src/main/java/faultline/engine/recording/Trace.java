package faultline.engine.recording;

import java.util.List;

/**
 * The numbers of a run, tick by tick.
 *
 * @param levels the same numbers at several resolutions, from one tick a bucket to the coarsest, which reaches back
 *     farthest
 */
public record Trace(List<TraceLevel> levels) {

    /** Of a run that is not recorded. */
    public static final Trace EMPTY = new TraceRecorder(0).view();

    public Trace {
        levels = List.copyOf(levels);
    }

    /**
     * How many ticks are recorded, tick 0 included.
     *
     * @return the tick after the newest
     */
    public long tickCount() {
        return finestLevel().endBucket();
    }

    /**
     * The level at full resolution.
     *
     * @return one tick a bucket
     */
    public TraceLevel finestLevel() {
        return levels.get(0);
    }

    /**
     * The finest level that still has the first of some ticks, and does not cut them into more than so many buckets.
     *
     * @param from the first tick
     * @param to the tick after the last
     * @param most how many buckets are enough
     * @return the coarsest level where none will do
     */
    public TraceLevel levelFor(long from, long to, int most) {
        return levels.stream()
                .filter(level -> level.firstBucket() * level.ticksPerBucket() <= Math.max(0, from)
                        && (to - from) / level.ticksPerBucket() <= most)
                .findFirst()
                .orElse(levels.get(levels.size() - 1));
    }
}
