package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.control.SensorTrust;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class DiagnosisRecorderTest {

    private static final ControllerSpec.WallFollowing FOLLOWER = ControllerSpec.WallFollowing.DEFAULT;

    /** Both sensors fail; while the diagnosis is off, they are mended. */
    private static final SimulationSetup SETUP = SimulationSetup.of(
                    new WorldSpec(6, 4, true, 3, List.of()), new Pose(1, 1, 0))
            .withTimeline(List.of(
                    new TimedCommand(5, new Command.InjectFault("front", new Fault.Dead())),
                    new TimedCommand(5, new Command.InjectFault("left", new Fault.Dead())),
                    new TimedCommand(20, new Command.ClearFaults("front")),
                    new TimedCommand(20, new Command.ClearFaults("left")),
                    new TimedCommand(20, new Command.ConfigureController(FOLLOWER.withDiagnosis(false))),
                    new TimedCommand(21, new Command.ConfigureController(FOLLOWER.withDiagnosis(true)))))
            .withDuration(30);

    @Test
    void trustThatReturnsWhileThereIsNoDiagnosisIsRecordedWhenThereIsOneAgain() {
        Map<SensorTrust, Long> events = new EnumMap<>(SensorTrust.class);
        DiagnosisRecorder recorder = new DiagnosisRecorder(event -> {
            if (event instanceof RunEvent.HealthChanged change
                    && List.of("front", "left").contains(change.health().sensor())) {
                events.merge(change.health().trust(), 1L, Long::sum);
            }
        });
        try (Simulation simulation = new Simulation(SETUP, ControllerMode.DIRECT)) {
            recorder.observe(simulation);
            while (simulation.ticks() < SETUP.ticks()) {
                simulation.tick();
                recorder.observe(simulation);
            }
        }
        assertEquals(2, events.get(SensorTrust.DISTRUSTED), events.toString());
        assertEquals(2, events.get(SensorTrust.TRUSTED), events.toString());
    }
}
