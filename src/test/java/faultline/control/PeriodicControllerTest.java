package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.wallfollower.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PeriodicControllerTest {

    private final List<Long> decisionTicks = new ArrayList<>();

    /** Asks for decisions at ticks 3 to 12 and returns the left voltages, which say at what tick each was made. */
    private List<Double> decide(double period) {
        Controller inner = observation -> {
            decisionTicks.add(observation.tick());
            return new Decision(observation.tick(), 0, Telemetry.ofState(ControllerState.of("TEST")));
        };
        PeriodicController periodic = new PeriodicController(inner, period);
        List<Double> volts = new ArrayList<>();
        for (long tick = 3; tick <= 12; tick++) {
            volts.add(periodic.decide(Observations.observation(tick, Map.of())).leftVolts());
        }
        return volts;
    }

    @Test
    void aPeriodOf0AsksEveryTick() {
        decide(0);
        assertEquals(10, decisionTicks.size());
    }

    @Test
    void betweenItsDecisionsTheLastOneHolds() {
        assertEquals(List.of(3.0, 3.0, 5.0, 5.0, 5.0, 5.0, 5.0, 10.0, 10.0, 10.0), decide(0.05));
        assertEquals(List.of(3L, 5L, 10L), decisionTicks);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "0.004, 1", "0.01, 1", "0.02, 2", "0.026, 3", "0.05, 5"})
    void aPeriodIsWholeTicksAndAtLeastOne(double period, long ticks) {
        assertEquals(ticks, PeriodicController.ticksPerPeriod(period, 0.01));
    }
}
