package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.sensor.SignalFault;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How long a fault could be seen, and how wrong the sensor was, until the diagnosis found it. */
class DiagnosisMetricsTest {

    private static final double ONSET = 20;

    private SimulationSetup office;

    @BeforeEach
    void read() throws ScenarioException {
        office = Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(80);
    }

    private DiagnosisMetrics run(String sensor, Fault fault) {
        SimulationSetup setup = office.withTimeline(
                List.of(new SimulationSetup.TimedCommand(ONSET, new Command.InjectFault(sensor, fault))));
        DiagnosisMetrics metrics = new DiagnosisMetrics(setup);
        HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(metrics));
        return metrics;
    }

    @Test
    void theErrorOfADriftBesideAWallGrowsUntilItIsDetected() {
        DiagnosisMetrics metrics = run("left", new SignalFault.Drift(0.01));
        double delay = metrics.detectionDelay().orElseThrow();
        assertEquals(delay, metrics.secondsInView().orElseThrow(), 0.02);
        assertEquals(0.01 * delay, metrics.errorBeforeDetection().orElseThrow(), 0.0002);
        assertTrue(delay > 1, "a small error cannot be detected: " + delay);
    }

    @Test
    void aSensorThatIsOffHasNoWrongReading() {
        DiagnosisMetrics metrics = run("left", new Fault.Dead());
        assertEquals(0, metrics.errorBeforeDetection().orElseThrow());
    }

    @Test
    void onlyTheTimeWithASurfaceInRangeCounts() {
        DiagnosisMetrics metrics = run("front", new Fault.Bias(0.15));
        double delay = metrics.detectionDelay().orElseThrow();
        assertTrue(metrics.secondsInView().orElseThrow() < delay - 1, "the front sensor sees nothing beside a wall");
        assertEquals(0.15, metrics.errorBeforeDetection().orElseThrow(), 1e-12);
    }

    @Test
    void withoutADetectionThereAreNoSuchMeasures() {
        DiagnosisMetrics metrics = run("left", new Fault.Bias(0.0001));
        assertTrue(metrics.detectionDelay().isEmpty());
        assertTrue(metrics.secondsInView().isEmpty());
        assertTrue(metrics.errorBeforeDetection().isEmpty());
    }
}
