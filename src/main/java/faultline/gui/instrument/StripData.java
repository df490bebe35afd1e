package faultline.gui.instrument;

import faultline.engine.SimulationSetup;
import faultline.engine.recording.Trace;
import faultline.engine.recording.TraceLevel;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/**
 * The buckets of a trace that a chart shows, at a resolution suitable for its width.
 *
 * @param level the trace at this resolution
 * @param sensors the ids of the robot's sensors, in its order
 * @param from the first bucket
 * @param to the bucket after the last
 * @param dt the length of a tick, seconds
 */
record StripData(TraceLevel level, List<String> sensors, long from, long to, double dt) {

    private static final int MAX_BUCKETS_PER_PIXEL = 3;

    /** Returns the recorded data in a time span, for a chart of the given width. */
    static StripData of(SessionFrame frame, TimeSpan span, int pixels) {
        return of(frame.recording().trace(), frame.snapshot().robot().sensorIds(), frame.dt(), span, pixels);
    }

    /** Returns the recorded data of a reference run in a time span, for a chart of the given width. */
    static StripData of(ReferenceRun run, TimeSpan span, int pixels) {
        SimulationSetup setup = run.setup();
        return of(run.recording().trace(), setup.robot().sensorIds(), setup.dt(), span, pixels);
    }

    private static StripData of(Trace trace, List<String> sensors, double dt, TimeSpan span, int pixels) {
        long first = (long) Math.floor(span.start() / dt);
        long last = (long) Math.ceil(span.end() / dt) + 1;
        TraceLevel level =
                trace.levelFor(Math.max(0, first), Math.min(last, trace.tickCount()), MAX_BUCKETS_PER_PIXEL * pixels);
        long from = Math.max(level.firstBucket(), Math.floorDiv(first, level.ticksPerBucket()));
        long to = Math.min(level.endBucket(), Math.floorDiv(last, level.ticksPerBucket()) + 1);
        return new StripData(level, sensors, Math.max(0, from), Math.max(from, to), dt);
    }

    /** Returns the length of a bucket, seconds. */
    double bucketLength() {
        return level.ticksPerBucket() * dt;
    }

    /** Returns the centre of a bucket, seconds. */
    double timeOf(long bucket) {
        return (bucket + 0.5) * level.ticksPerBucket() * dt - dt / 2;
    }

    /** Returns the time of the last tick of the last bucket, seconds. */
    double lastTime() {
        return (to * level.ticksPerBucket() - 1) * dt;
    }

    /** Returns the bucket nearest to a time, or -1 if there is none. */
    long bucketAt(double time) {
        return from < to ? Math.max(from, Math.min(to - 1, bucketOf(time))) : -1;
    }

    /** Returns the index of a time, whether there is a bucket or not. */
    long bucketOf(double time) {
        return Math.floorDiv(Math.round(time / dt), level.ticksPerBucket());
    }

    /** The values of a line in the unit in which they are shown. */
    record LineValues(TraceLevel level, int channel, double factor) {

        /** Returns the least value in a bucket as {@link TraceLevel#min} does. */
        float min(long bucket) {
            return (float) (factor * level.min(channel, bucket));
        }

        /** Returns the greatest value in a bucket as {@link TraceLevel#max} does. */
        float max(long bucket) {
            return (float) (factor * level.max(channel, bucket));
        }

        /** Returns the middle between the two. */
        float middle(long bucket) {
            return (min(bucket) + max(bucket)) / 2;
        }
    }

    /** Returns the values of a line; empty if the robot lacks its sensor. */
    Optional<LineValues> valuesOf(ChartLine line) {
        OptionalInt channel = line.channelIn(sensors);
        return channel.isPresent()
                ? Optional.of(new LineValues(level, channel.getAsInt(), line.factor()))
                : Optional.empty();
    }

    /** Returns all values of a line without gaps. */
    DoubleStream values(ChartLine line) {
        return valuesOf(line).stream().flatMapToDouble(shown -> LongStream.range(from, to)
                .mapToObj(bucket -> DoubleStream.of(shown.min(bucket), shown.max(bucket)))
                .flatMapToDouble(both -> both)
                .filter(Double::isFinite));
    }
}
