package faultline.engine.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalLong;
import java.util.Random;
import java.util.function.LongUnaryOperator;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class HashesTest {

    private static HashRecorder recorder(int size, LongUnaryOperator hash) {
        HashRecorder recorder = new HashRecorder();
        LongStream.range(0, size).map(hash).forEach(recorder::add);
        return recorder;
    }

    @Test
    void aViewKeepsItsLengthWhileTheRecordingGoesOn() {
        HashRecorder recorder = recorder(10, tick -> 3 * tick);
        Hashes early = recorder.view();
        recorder.add(77);
        assertEquals(10, early.size());
        assertEquals(77, recorder.view().at(10));
        assertTrue(recorder.view().continues(early));
        assertFalse(early.continues(recorder.view()));
    }

    @Test
    void anotherRecordingDoesNotContinueItHoweverAlike() {
        assertFalse(recorder(10, tick -> tick).view().continues(recorder(10, tick -> tick).view()));
        assertFalse(recorder(10, tick -> tick).view().continues(Hashes.EMPTY));
    }

    @Test
    void theFirstDifferenceIsTheOneThatLookingAtEachTickFinds() {
        Random random = new Random(11);
        for (int trial = 0; trial < 300; trial++) {
            int size = 1 + random.nextInt(3 * HashRecorder.CHUNK);
            int other = 1 + random.nextInt(3 * HashRecorder.CHUNK);
            int changed = random.nextInt(3 * HashRecorder.CHUNK);
            Hashes one = recorder(size, tick -> tick).view();
            Hashes two = recorder(other, tick -> tick >= changed ? -tick - 1 : tick).view();
            int from = random.nextInt(Math.min(size, other));
            OptionalLong expected = LongStream.range(from, Math.min(size, other)).filter(tick -> one.at(tick) != two.at(tick)).findFirst();
            assertEquals(expected, one.firstDifference(two, from));
            assertEquals(expected, two.firstDifference(one, from));
        }
    }

    @Test
    void beyondTheMostNothingIsRecorded() {
        HashRecorder recorder = recorder(HashRecorder.MOST, tick -> tick);
        recorder.add(1);
        assertEquals(HashRecorder.MOST, recorder.view().size());
    }
}
