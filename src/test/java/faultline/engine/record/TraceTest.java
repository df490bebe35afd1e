package faultline.engine.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Traces at several resolutions: what is kept, how it is thinned, and that views stay as they are. */
class TraceTest {

    private final TraceRecorder recorder = new TraceRecorder(2);

    /** Channel 0 counts the ticks, channel 1 is always 5. */
    private Trace after(int ticks) {
        for (int i = 0; i < ticks; i++) {
            recorder.add(new float[] {i, 5});
        }
        return recorder.view();
    }

    @Test
    void atFullResolutionEveryTickIsAsItWas() {
        Level level = after(100).finest();
        assertEquals(1, level.ticksPerBucket());
        assertEquals(100, level.end());
        assertEquals(37, level.low(0, 37));
        assertEquals(37, level.high(0, 37));
        assertEquals(5, level.low(1, 99));
    }

    @Test
    void aCoarserBucketSpansItsTicks() {
        Level level = after(100).levels().get(1);
        assertEquals(4, level.ticksPerBucket());
        assertEquals(25, level.end(), "only whole buckets");
        assertEquals(8, level.low(0, 2));
        assertEquals(11, level.high(0, 2));
        Level coarser = recorder.view().levels().get(2);
        assertEquals(6, coarser.end());
        assertEquals(32, coarser.low(0, 2));
        assertEquals(47, coarser.high(0, 2));
    }

    @Test
    void gapsAndNothingWithinRangeLeaveNoMarkInACoarserBucket() {
        for (float value : new float[] {Float.NaN, Float.POSITIVE_INFINITY, 3, Float.NaN, 2, Float.POSITIVE_INFINITY}) {
            recorder.add(new float[] {value, Float.NaN});
        }
        for (int i = 6; i < 16; i++) {
            recorder.add(new float[] {2.5f, Float.POSITIVE_INFINITY});
        }
        Level level = recorder.view().levels().get(2);
        assertEquals(2, level.low(0, 0));
        assertEquals(3, level.high(0, 0));
        assertTrue(Float.isNaN(level.low(1, 0)));
        assertEquals(Float.POSITIVE_INFINITY, recorder.view().finest().low(0, 1), "at full resolution nothing is nothing");
    }

    @Test
    void aViewStaysAsItIsWhileTheRecordingGoesOnAndForgets() {
        Trace early = after(5000);
        after(1_000_000);
        assertEquals(5000, early.end());
        for (int tick = 0; tick < 5000; tick++) {
            assertEquals(tick, early.finest().low(0, tick));
        }
        assertThrows(IndexOutOfBoundsException.class, () -> early.finest().low(0, 5000));
    }

    @Test
    void anHourAtFullSpeedKeepsTheNewestTicksAndTheWholeRun() {
        Trace trace = after(3_000_000);
        Level finest = trace.finest();
        assertEquals(3_000_000, finest.end());
        assertTrue(finest.end() - finest.first() > 28_000 && finest.end() - finest.first() <= 32_768);
        assertEquals(2_999_999, finest.low(0, 2_999_999));
        assertThrows(IndexOutOfBoundsException.class, () -> finest.low(0, finest.first() - 1));
        Level whole = trace.level(0, 3_000_000, 20_000);
        assertEquals(0, whole.first());
        assertEquals(256, whole.ticksPerBucket());
        assertEquals(256, whole.low(0, 1));
        assertEquals(511, whole.high(0, 1));
    }

    @Test
    void noLevelKeepsMoreThanItsShareHoweverLongTheRun() {
        Trace trace = after(3_000_000);
        for (Level level : trace.levels()) {
            assertTrue(level.end() - level.first() <= (level.ticksPerBucket() == 1 ? 32_768 : 16_384), "buckets of " + level.ticksPerBucket());
        }
    }

    @Test
    void theFinestLevelThatIsCoarseEnoughIsChosen() {
        Trace trace = after(100_000);
        assertSame(trace.levels().get(0), trace.level(99_000, 100_000, 1000));
        assertSame(trace.levels().get(1), trace.level(99_000, 100_000, 999));
        assertSame(trace.levels().get(2), trace.level(0, 1000, 1000), "the finer ones have forgotten tick 0");
        assertSame(trace.levels().get(4), trace.level(0, 100_000, 1000));
    }

    @Test
    void anEmptyTraceHasNothing() {
        assertEquals(0, Trace.EMPTY.end());
    }
}
