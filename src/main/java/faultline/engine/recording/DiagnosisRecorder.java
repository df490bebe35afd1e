package faultline.engine.recording;

import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.Telemetry;
import faultline.control.ladder.Rung;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.util.List;
import java.util.function.Consumer;

/**
 * Converts the output of a controller's diagnosis to events: changes of the trust in a sensor, and changes of rung. A
 * run begins on the highest rung with all sensors trusted.
 */
public final class DiagnosisRecorder implements TickObserver {

    private final Consumer<RunEvent> events;
    private List<SensorHealth> health = List.of();
    private String rung = Rung.ALL.name();

    /**
     * Creates a recorder of one run.
     *
     * @param events receives the events in order
     */
    public DiagnosisRecorder(Consumer<RunEvent> events) {
        this.events = events;
    }

    @Override
    public void observe(Simulation simulation) {
        Telemetry.Diagnosis now = simulation.telemetry().diagnosis();
        if (!now.health().isEmpty() && now.health() != health) {
            for (int i = 0; i < now.health().size(); i++) {
                compare(i, now.health().get(i), simulation);
            }
            health = now.health();
        }
        if (!now.rung().isEmpty() && !now.rung().equals(rung)) {
            events.accept(new RunEvent.RungChanged(simulation.ticks(), timeOf(simulation), rung, now.rung()));
            rung = now.rung();
        }
    }

    private void compare(int sensor, SensorHealth now, Simulation simulation) {
        SensorTrust before = sensor < health.size() ? health.get(sensor).trust() : SensorTrust.TRUSTED;
        if (now.trust() != before) {
            events.accept(new RunEvent.HealthChanged(simulation.ticks(), timeOf(simulation), before, now));
        }
    }

    private static double timeOf(Simulation simulation) {
        return simulation.setup().timeOf(simulation.ticks());
    }
}
