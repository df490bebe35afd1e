package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalLong;
import java.util.Random;
import java.util.function.LongUnaryOperator;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class HashTraceTest {

    private static HashTraceRecorder recorder(int size, LongUnaryOperator hash) {
        HashTraceRecorder recorder = new HashTraceRecorder();
        LongStream.range(0, size).map(hash).forEach(recorder::add);
        return recorder;
    }

    @Test
    void aViewKeepsItsLengthWhileTheRecordingGoesOn() {
        HashTraceRecorder recorder = recorder(10, tick -> 3 * tick);
        HashTrace early = recorder.view();
        recorder.add(77);
        assertEquals(10, early.size());
        assertEquals(77, recorder.view().hashAt(10));
        assertTrue(recorder.view().isContinuationOf(early));
        assertFalse(early.isContinuationOf(recorder.view()));
    }

    @Test
    void anEqualRecordingIsNoContinuation() {
        assertFalse(recorder(10, tick -> tick)
                .view()
                .isContinuationOf(recorder(10, tick -> tick).view()));
        assertFalse(recorder(10, tick -> tick).view().isContinuationOf(HashTrace.EMPTY));
    }

    @Test
    void theFirstDifferenceIsTheOneThatLookingAtEachTickFinds() {
        Random random = new Random(11);
        for (int trial = 0; trial < 300; trial++) {
            int size = 1 + random.nextInt(3 * HashTraceRecorder.CHUNK_SIZE);
            int other = 1 + random.nextInt(3 * HashTraceRecorder.CHUNK_SIZE);
            int changed = random.nextInt(3 * HashTraceRecorder.CHUNK_SIZE);
            HashTrace one = recorder(size, tick -> tick).view();
            HashTrace two =
                    recorder(other, tick -> tick >= changed ? -tick - 1 : tick).view();
            int from = random.nextInt(Math.min(size, other));
            OptionalLong expected = LongStream.range(from, Math.min(size, other))
                    .filter(tick -> one.hashAt(tick) != two.hashAt(tick))
                    .findFirst();
            assertEquals(expected, one.firstDifference(two, from));
            assertEquals(expected, two.firstDifference(one, from));
        }
    }

    @Test
    void beyondTheMaximumNothingIsRecorded() {
        HashTraceRecorder recorder = recorder(HashTraceRecorder.MAX_HASHES, tick -> tick);
        recorder.add(1);
        assertEquals(HashTraceRecorder.MAX_HASHES, recorder.view().size());
    }
}
