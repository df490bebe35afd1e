package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class EndNotifierTest {

    private static final double TICK = 0.01;
    private static final String NOTE =
            "The scenario ended at 10.00 s. The run continues until it is paused or restarted";

    private final List<String> notes = new ArrayList<>();
    private final EndNotifier notifier = new EndNotifier(notes::add);
    private SimulationSetup setup;

    @BeforeEach
    void load() throws ScenarioException {
        setup = Scenario.load(Path.of("scenarios/office.xml"))
                .setup()
                .withTick(TICK)
                .withDuration(10);
    }

    @Test
    void aRunThatPassesItsEndIsReportedOnce() {
        for (long tick : new long[] {999, 1000, 1001, 5000, 1000}) {
            notifier.update(tick, TICK, setup);
        }
        assertEquals(List.of(NOTE), notes);
        notifier.update(1001, TICK, setup);
        assertEquals(List.of(NOTE, NOTE), notes);
    }

    /** As after a change of the length of the ticks whose restart was cancelled. */
    @Test
    void theEndIsAtTheDurationWhateverTheTicksOfTheScenario() {
        notifier.update(1000, TICK, setup.withTick(2 * TICK));
        assertEquals(List.of(), notes);
        notifier.update(1001, TICK, setup.withTick(TICK / 2));
        assertEquals(List.of(NOTE), notes);
    }
}
