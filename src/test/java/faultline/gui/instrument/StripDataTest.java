package faultline.gui.instrument;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.recording.TraceChannels;
import faultline.engine.session.SessionFrame;
import faultline.world.SensorSnapshot;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** The times and the values of the points of a strip chart. */
class StripDataTest {

    private static final SessionFrame FRAME = SampleRuns.frame(2000);
    private static final double DT = 0.01;

    /**
     * The width of a chart that has a bucket for each tick of ten seconds, and that of one with several ticks, pixels.
     */
    private static final int WIDE = 1000;

    private static final int NARROW = 20;

    /** The robot drives towards a wall. */
    @Test
    void aPointHasTheValueThatTheSensorHadAtItsTime() {
        StripData data = StripData.of(FRAME, new TimeSpan(1, 10), WIDE);
        int front = FRAME.snapshot().robot().indexOf("front");
        float last = Float.NaN;
        for (long tick : new long[] {450, 451, 452}) {
            SensorSnapshot sensor = SampleRuns.frame(tick).snapshot().sensors().get(front);
            long bucket = data.bucketAt(tick * DT);
            assertEquals(tick * DT, data.timeOf(bucket), 1e-9);
            float value = data.level().min(TraceChannels.trueReading(front), bucket);
            assertEquals((float) sensor.truth().encoded(), value);
            assertNotEquals(last, value);
            last = value;
        }
    }

    @Test
    void aPointOfSeveralTicksIsAtTheirMeanTime() {
        StripData data = StripData.of(FRAME, new TimeSpan(5, 10), NARROW);
        assertTrue(data.level().ticksPerBucket() > 1, data.toString());
        for (long bucket = data.from(); bucket < data.to(); bucket++) {
            long wanted = bucket;
            double mean = LongStream.rangeClosed(0, 2000)
                    .filter(tick -> data.bucketOf(tick * DT) == wanted)
                    .mapToDouble(tick -> tick * DT)
                    .average()
                    .orElseThrow();
            assertEquals(mean, data.timeOf(bucket), 1e-9);
        }
    }

    /** Otherwise the lines would begin or end beside the edge. */
    @Test
    void theFirstAndTheLastPointAreNotInsideTheSpan() {
        for (int width : new int[] {WIDE, NARROW}) {
            for (int tick = 0; tick < 64; tick++) {
                TimeSpan span = new TimeSpan(5 + tick * DT, 10);
                StripData data = StripData.of(FRAME, span, width);
                assertTrue(data.bucketOf(span.start()) >= data.from(), span + " " + data);
                assertTrue(data.bucketOf(span.end()) < data.to(), span + " " + data);
            }
        }
    }
}
