package faultline.engine.recording;

import java.util.List;

/**
 * The numbers of a run, tick by tick.
 *
 * @param levels the same numbers at several resolutions, from one tick per bucket to the coarsest, which reaches back
 *     farthest
 */
public record Trace(List<TraceLevel> levels) {

    /** The trace of a run that is not recorded. */
    public static final Trace EMPTY = new TraceRecorder(0).view();

    /**
     * Creates a trace from a copy of the levels.
     *
     * @param levels the same numbers at several resolutions, from one tick per bucket to the coarsest, which reaches
     *     back farthest
     */
    public Trace {
        levels = List.copyOf(levels);
    }

    /** {@return the number of recorded ticks, including tick 0} */
    public long tickCount() {
        return finestLevel().endBucket();
    }

    /** {@return the level with one tick to a bucket} */
    public TraceLevel finestLevel() {
        return levels.get(0);
    }

    /**
     * {@return the finest level that still contains a tick and whose buckets in a range of ticks are at most a number;
     * the coarsest level if none is} The range may also cut a bucket at each end.
     *
     * @param from the first tick
     * @param to the tick after the last
     * @param most the greatest number of whole buckets
     */
    public TraceLevel levelFor(long from, long to, int most) {
        return levels.stream()
                .filter(level -> level.firstBucket() * level.ticksPerBucket() <= Math.max(0, from)
                        && (to - from) / level.ticksPerBucket() <= most)
                .findFirst()
                .orElse(levels.get(levels.size() - 1));
    }
}
