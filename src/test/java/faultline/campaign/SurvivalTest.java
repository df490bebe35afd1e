package faultline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.SurvivalTrial.Conditions;
import faultline.campaign.SurvivalTrial.Outcome;
import faultline.control.WallSide;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A short version of the study of docs/faults.md, in other rooms. */
class SurvivalTest {

    private static Outcome run(long room, List<DrawnFault> faults, List<Integer> sensors, int off) {
        WallSide side = room % 2 == 0 ? WallSide.RIGHT : WallSide.LEFT;
        return new SurvivalTrial(room, faults, sensors, off, new Conditions(true, side, 0, 0)).run();
    }

    @ParameterizedTest
    @CsvSource({
        "OFF,0",
        "OFF,2",
        "STUCK,0",
        "STUCK_WANTED,2",
        "BIAS,2",
        "DRIFT_FAR,2",
        "DROPOUT,2",
        "NOISE,2",
        "SHORT_RANGE,2",
        "GHOST,0"
    })
    void aRobotWithOneFailingSensorCarriesOn(DrawnFault kind, int sensor) {
        for (long room = 90_001; room < 90_003; room++) {
            Outcome outcome = run(room, List.of(kind), List.of(sensor), 0);
            assertTrue(outcome.carriedOn(), outcome::note);
        }
    }

    @Test
    void healthySensorsStayTrusted() {
        for (long room = 91_001; room < 91_007; room++) {
            Outcome outcome = run(room, List.of(), List.of(), 0);
            assertTrue(outcome.carriedOn(), outcome::note);
            assertFalse(outcome.lowerRung(), outcome::note);
        }
    }

    /**
     * Beside corners and furniture, where two sensors alone contradict each other; the median was 2.7 s without jumps.
     */
    @Test
    void aJumpOfBiasIsFoundSoon() {
        double[] delays = LongStream.range(97_001, 97_013)
                .mapToObj(room -> new SurvivalTrial(room, List.of(DrawnFault.BIAS), List.of(3), 0, Conditions.STANDARD))
                .mapToDouble(trial -> trial.run().delay())
                .sorted()
                .toArray();
        assertTrue(delays[6] < 2.2, "found after " + Arrays.toString(delays));
    }

    /** A front sensor that is stuck at nothing; robots that drove on touched something in each of these rooms. */
    @ParameterizedTest
    @ValueSource(longs = {98_013, 98_022, 98_026, 98_030, 98_033})
    void aSurfaceThatTheFrontSensorMissesIsNotTouched(long room) {
        Outcome outcome =
                new SurvivalTrial(room, List.of(DrawnFault.STUCK_AT_LAST), List.of(0), 0, Conditions.STANDARD).run();
        assertTrue(outcome.carriedOn(), outcome::note);
    }

    @ParameterizedTest
    @CsvSource({"11111111", "10111111", "11110001"})
    void withoutASensorOnTheWallsSideTheRobotStops(String off) {
        int mask = Integer.parseInt(off, 2) | 0b1110;
        Outcome outcome = new SurvivalTrial(92_001, List.of(), List.of(), mask, Conditions.STANDARD).run();
        assertTrue(outcome.stopped(), outcome::note);
        assertFalse(outcome.contact(), outcome::note);
    }

    /** Sets of sensors of which none looks ahead; names are those for a wall on the left. */
    @ParameterizedTest
    @CsvSource({
        "left,4",
        "rear-left front-right,5",
        "left rear-left,4",
        "rear-left,6",
        "rear-left rear,8",
        "rear-left right,8"
    })
    void withoutASensorThatLooksAheadItGetsRoundInTime(String on, int least) {
        int carriedOn = 0;
        for (long room = 93_001; room < 93_009; room++) {
            int off = 0xFF & ~mask(Set.of(on.split(" ")), room % 2 == 0);
            Outcome outcome = run(room, List.of(), List.of(), off);
            assertFalse(outcome.contact(), outcome::note);
            carriedOn += outcome.carriedOn() ? 1 : 0;
        }
        assertTrue(carriedOn >= least, carriedOn + " of 8");
    }

    private static int mask(Set<String> sensors, boolean mirrored) {
        int n = SurvivalTrial.SENSORS.size();
        return sensors.stream()
                .mapToInt(SurvivalTrial.SENSORS::indexOf)
                .map(sensor -> 1 << (mirrored ? (n - sensor) % n : sensor))
                .sum();
    }

    @Test
    void theSameSeedGivesTheSameRoom() {
        assertEquals(RandomRoom.ofSeed(5), RandomRoom.ofSeed(5));
    }
}
