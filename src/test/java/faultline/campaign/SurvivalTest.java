package faultline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.SurvivalStudy.Outcome;
import faultline.campaign.SurvivalStudy.Trial;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A short version of the study of docs/faults.md, on seeds of its own. */
class SurvivalTest {

    private static Trial trial(long seed, List<String> kinds, List<Integer> sensors, int offMask) {
        return new Trial(seed, kinds, sensors, true, offMask, 0, 0, seed % 2 == 0);
    }

    @ParameterizedTest
    @CsvSource({
        "off,0",
        "off,2",
        "stuck,0",
        "stuckwanted,2",
        "bias,2",
        "drift,2",
        "dropout,2",
        "noise,2",
        "range,2",
        "ghost,0"
    })
    void aRobotWithOneFailingSensorCarriesOn(String kind, int sensor) {
        for (long seed = 90_001; seed < 90_003; seed++) {
            Outcome outcome = SurvivalStudy.run(trial(seed, List.of(kind), List.of(sensor), 0));
            assertTrue(outcome.carried(), outcome::toString);
        }
    }

    @Test
    void healthySensorsStayTrusted() {
        for (long seed = 91_001; seed < 91_007; seed++) {
            Outcome outcome = SurvivalStudy.run(trial(seed, List.of(), List.of(), 0));
            assertTrue(outcome.carried(), outcome::toString);
            assertFalse(outcome.lowerRung(), outcome::toString);
        }
    }

    @ParameterizedTest
    @CsvSource({"11111111", "10111111", "11110001"})
    void withoutASensorOnTheWallsSideTheRobotStops(String offMask) {
        int mask = Integer.parseInt(offMask, 2) | 0b1110;
        Outcome outcome = SurvivalStudy.run(new Trial(92_001, List.of(), List.of(), true, mask, 0, 0, false));
        assertTrue(outcome.stopped(), outcome::toString);
        assertFalse(outcome.contact(), outcome::toString);
    }

    @Test
    void theSameSeedGivesTheSameRoom() {
        assertEquals(RandomRoom.ofSeed(5), RandomRoom.ofSeed(5));
    }
}
