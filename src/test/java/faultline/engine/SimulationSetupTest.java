package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.scenario.Scenario;
import org.junit.jupiter.api.Test;

class SimulationSetupTest {

    @Test
    void theTimeOfATickHasNoRoundingError() throws Exception {
        SimulationSetup setup = Scenario.loadShipped("office.xml").setup();
        assertEquals(0.01, setup.dt());
        assertEquals("35.91", String.valueOf(setup.timeOf(3591)));
        for (long tick = 0; tick < 100_000; tick++) {
            assertEquals(tick, setup.tickAt(setup.timeOf(tick)));
        }
    }
}
