package faultline.gui.instrument;

import faultline.engine.recording.Trace;
import faultline.engine.recording.TraceLevel;
import faultline.engine.session.SessionFrame;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/**
 * The buckets of a trace that a chart shows, without the one at the end, at a resolution suitable for its width;
 * {@code dt} is the length of a tick, seconds.
 */
record StripData(TraceLevel level, long from, long to, double dt) {

    private static final int MAX_BUCKETS_PER_PIXEL = 3;

    /** Returns the recorded data in a time span, for a chart of the given width. */
    static StripData of(SessionFrame frame, TimeSpan span, int pixels) {
        // At tick 0 the length of a tick is not known and not needed.
        double dt = frame.snapshot().tick() > 0
                ? frame.snapshot().time() / frame.snapshot().tick()
                : 1;
        return of(frame.recording().trace(), dt, span, pixels);
    }

    /** Returns the data of a trace in a time span; {@code dt} is the length of a tick, seconds. */
    static StripData of(Trace trace, double dt, TimeSpan span, int pixels) {
        long first = (long) Math.floor(span.start() / dt);
        long last = (long) Math.ceil(span.end() / dt) + 1;
        TraceLevel level =
                trace.levelFor(Math.max(0, first), Math.min(last, trace.tickCount()), MAX_BUCKETS_PER_PIXEL * pixels);
        long from = Math.max(level.firstBucket(), Math.floorDiv(first, level.ticksPerBucket()));
        long to = Math.min(level.endBucket(), Math.floorDiv(last, level.ticksPerBucket()) + 1);
        return new StripData(level, Math.max(0, from), Math.max(from, to), dt);
    }

    /** Returns the centre of a bucket, seconds. */
    double timeOf(long bucket) {
        return (bucket + 0.5) * level.ticksPerBucket() * dt - dt / 2;
    }

    /** Returns the bucket nearest to a time, or -1 if there is none. */
    long bucketAt(double time) {
        return from < to ? Math.max(from, Math.min(to - 1, bucketOf(time))) : -1;
    }

    /** Returns the index of a time, whether there is a bucket or not. */
    long bucketOf(double time) {
        return Math.floorDiv(Math.round(time / dt), level.ticksPerBucket());
    }

    /** Returns whether a line is recorded; another robot may have fewer sensors. */
    boolean contains(ChartLine line) {
        return line.channel() < level.channelCount();
    }

    /** Returns all values of a line without gaps. */
    DoubleStream values(ChartLine curve) {
        if (!contains(curve)) {
            return DoubleStream.empty();
        }
        return LongStream.range(from, to)
                .mapToObj(bucket ->
                        DoubleStream.of(level.min(curve.channel(), bucket), level.max(curve.channel(), bucket)))
                .flatMapToDouble(both -> both)
                .filter(Double::isFinite);
    }
}
