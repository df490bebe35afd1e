package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** The ratio of the number of runs to the number of independent runs that they are worth. */
class DesignEffectTest {

    @Test
    void threeWorldsOfTwoEqualRunsAreWorthTwoRuns() {
        // 1 1, 1 1 and 0 0 with a mean of 2/3: (4/9 + 4/9 + 16/9) 3/2 = 4 over 6 * 2/9 = 4/3.
        Map<String, Double> sums = Map.of("a", 2 / 3.0, "b", 2 / 3.0, "c", -4 / 3.0);
        assertEquals(3, Survival.designEffect(6, sums, 4 / 3.0), 1e-12);
    }

    @Test
    void worldsThatAreMoreAlikeThanTheirRunsMakeNoRunWorthMoreThanOne() {
        // 1 0 in each world.
        assertEquals(1, Survival.designEffect(4, Map.of("a", 0.0, "b", 0.0), 1));
    }

    @Test
    void ifNoRunsDifferEachWorldIsWorthOneRun() {
        assertEquals(2, Survival.designEffect(6, Map.of("a", 0.0, "b", 0.0, "c", 0.0), 0));
    }

    @Test
    void theRunsOfOneWorldAreWorthOneRun() {
        assertEquals(5, Survival.designEffect(5, Map.of("a", 0.0), 1.2));
    }

    @Test
    void oneRunInEachWorldIsIndependentOfTheOthers() {
        assertEquals(1, Survival.designEffect(2, Map.of("a", 0.5, "b", -0.5), 0.5));
        assertEquals(1, Survival.designEffect(1, Map.of("a", 0.0), 0));
    }
}
