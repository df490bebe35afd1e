package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Traces at several resolutions: what is kept, how it is thinned, and that views stay as they are. */
class TraceTest {

    private final TraceRecorder recorder = new TraceRecorder(2);

    /** Channel 0 counts the ticks, channel 1 is always 5. */
    private Trace traceOf(int ticks) {
        for (int i = 0; i < ticks; i++) {
            recorder.add(new float[] {i, 5});
        }
        return recorder.view();
    }

    @Test
    void atFullResolutionEveryTickIsAsItWas() {
        TraceLevel level = traceOf(100).finestLevel();
        assertEquals(1, level.ticksPerBucket());
        assertEquals(100, level.endBucket());
        assertEquals(37, level.min(0, 37));
        assertEquals(37, level.max(0, 37));
        assertEquals(5, level.min(1, 99));
    }

    @Test
    void aCoarserBucketSpansItsTicks() {
        TraceLevel level = traceOf(100).levels().get(1);
        assertEquals(4, level.ticksPerBucket());
        assertEquals(25, level.endBucket(), "only whole buckets");
        assertEquals(8, level.min(0, 2));
        assertEquals(11, level.max(0, 2));
        TraceLevel coarser = recorder.view().levels().get(2);
        assertEquals(6, coarser.endBucket());
        assertEquals(32, coarser.min(0, 2));
        assertEquals(47, coarser.max(0, 2));
    }

    @Test
    void gapsAndNothingWithinRangeLeaveNoMarkInACoarserBucket() {
        for (float value : new float[] {Float.NaN, Float.POSITIVE_INFINITY, 3, Float.NaN, 2, Float.POSITIVE_INFINITY}) {
            recorder.add(new float[] {value, Float.NaN});
        }
        for (int i = 6; i < 16; i++) {
            recorder.add(new float[] {2.5f, Float.POSITIVE_INFINITY});
        }
        TraceLevel level = recorder.view().levels().get(2);
        assertEquals(2, level.min(0, 0));
        assertEquals(3, level.max(0, 0));
        assertTrue(Float.isNaN(level.min(1, 0)));
        assertEquals(
                Float.POSITIVE_INFINITY,
                recorder.view().finestLevel().min(0, 1),
                "at full resolution nothing is nothing");
    }

    @Test
    void aViewStaysAsItIsWhileTheRecordingGoesOnAndForgets() {
        Trace early = traceOf(5000);
        traceOf(1_000_000);
        assertEquals(5000, early.tickCount());
        for (int tick = 0; tick < 5000; tick++) {
            assertEquals(tick, early.finestLevel().min(0, tick));
        }
        assertThrows(IndexOutOfBoundsException.class, () -> early.finestLevel().min(0, 5000));
    }

    @Test
    void anHourAtFullSpeedKeepsTheNewestTicksAndTheWholeRun() {
        Trace trace = traceOf(3_000_000);
        TraceLevel finest = trace.finestLevel();
        assertEquals(3_000_000, finest.endBucket());
        assertTrue(finest.endBucket() - finest.firstBucket() > 28_000
                && finest.endBucket() - finest.firstBucket() <= 32_768);
        assertEquals(2_999_999, finest.min(0, 2_999_999));
        assertThrows(IndexOutOfBoundsException.class, () -> finest.min(0, finest.firstBucket() - 1));
        TraceLevel whole = trace.levelFor(0, 3_000_000, 20_000);
        assertEquals(0, whole.firstBucket());
        assertEquals(256, whole.ticksPerBucket());
        assertEquals(256, whole.min(0, 1));
        assertEquals(511, whole.max(0, 1));
    }

    @Test
    void noLevelKeepsMoreThanItsShareHoweverLongTheRun() {
        Trace trace = traceOf(3_000_000);
        for (TraceLevel level : trace.levels()) {
            assertTrue(
                    level.endBucket() - level.firstBucket() <= (level.ticksPerBucket() == 1 ? 32_768 : 16_384),
                    "buckets of " + level.ticksPerBucket());
        }
    }

    /** A value takes four bytes, and a coarse bucket has two for each channel. */
    @ParameterizedTest
    @ValueSource(ints = {24, 70, 72, 500, 2024})
    void withManyChannelsFewerTicksAreKeptInTheSameMemory(int channels) {
        TraceRecorder many = new TraceRecorder(channels);
        float[] tick = new float[channels];
        for (int i = 0; i < 20_000_000 / channels; i++) {
            Arrays.fill(tick, i);
            many.add(tick);
        }
        Trace trace = many.view();
        long values = trace.levels().stream()
                .mapToLong(level ->
                        (level.endBucket() - level.firstBucket()) * channels * (level.ticksPerBucket() == 1 ? 1 : 2))
                .sum();
        assertTrue(values <= 16_100_000, values + " values");
        TraceLevel finest = trace.finestLevel();
        assertTrue(finest.endBucket() - finest.firstBucket() >= Math.min(finest.endBucket(), 896), "9 s at 10 ms");
        assertEquals(finest.endBucket() - 1, finest.min(channels - 1, finest.endBucket() - 1));
        assertEquals(finest.firstBucket(), finest.min(0, finest.firstBucket()));
    }

    @Test
    void theFinestLevelThatIsCoarseEnoughIsChosen() {
        Trace trace = traceOf(100_000);
        assertSame(trace.levels().get(0), trace.levelFor(99_000, 100_000, 1000));
        assertSame(trace.levels().get(1), trace.levelFor(99_000, 100_000, 999));
        assertSame(trace.levels().get(2), trace.levelFor(0, 1000, 1000), "the finer ones have forgotten tick 0");
        assertSame(trace.levels().get(2), trace.levelFor(10_000, 11_000, 1000), "the finer ones begin later");
        assertSame(trace.levels().get(4), trace.levelFor(0, 100_000, 1000));
        assertSame(trace.levels().get(6), trace.levelFor(0, 100_000, 10), "no level is coarse enough");
    }

    @Test
    void anEmptyTraceHasNothing() {
        assertEquals(0, Trace.EMPTY.tickCount());
    }
}
