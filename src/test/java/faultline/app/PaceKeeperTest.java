package faultline.app;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.scenario.Scenario;
import org.junit.jupiter.api.Test;

class PaceKeeperTest {

    private static final long PREPARATION_NANOS = 80_000_000;

    /** Time that passes before the run begins must not be caught up, or the run is faster than its pace. */
    @Test
    void theTimeOfARunBeginsWithItsFirstObservation() throws Exception {
        try (Simulation simulation =
                new Simulation(Scenario.loadShipped("beside-a-wall.xml").setup(), ControllerMode.DIRECT)) {
            PaceKeeper keeper = new PaceKeeper(1);
            long created = System.nanoTime();
            while (System.nanoTime() - created < PREPARATION_NANOS) {
                Thread.onSpinWait();
            }
            long began = System.nanoTime();
            keeper.observe(simulation);
            for (int tick = 1; tick <= 5; tick++) {
                simulation.tick();
                keeper.observe(simulation);
            }
            double seconds = (System.nanoTime() - began) / 1e9;
            assertTrue(seconds >= 5 * simulation.setup().dt(), () -> seconds + " s");
        }
    }
}
