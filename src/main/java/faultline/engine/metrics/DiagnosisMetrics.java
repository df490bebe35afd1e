package faultline.engine.metrics;

import faultline.control.SensorHealth;
import faultline.control.Telemetry;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;

/** Compares the findings of a controller's diagnosis with the actual faults of the sensors. */
public final class DiagnosisMetrics implements TickObserver {

    private final double onset;
    private final Set<String> faulty = new HashSet<>();
    private final String firstFaulty;
    private final Set<String> wronglyDistrusted = new HashSet<>();
    private double detected = Double.NaN;
    private String rung = "";
    private boolean diagnosed;

    /**
     * Creates metrics of one run of a setup.
     *
     * @param setup the setup of the run
     */
    public DiagnosisMetrics(SimulationSetup setup) {
        onset = CarryOnMetrics.faultTimes(setup).min().orElse(0);
        setup.timeline().stream()
                .filter(timed -> timed.command() instanceof Command.InjectFault)
                .forEach(timed -> faulty.add(((Command.InjectFault) timed.command()).sensor()));
        firstFaulty = setup.timeline().stream()
                .filter(timed -> timed.time() == onset && timed.command() instanceof Command.InjectFault)
                .map(timed -> ((Command.InjectFault) timed.command()).sensor())
                .findFirst()
                .orElse("");
    }

    @Override
    public void observe(Simulation simulation) {
        Telemetry.Diagnosis diagnosis = simulation.telemetry().diagnosis();
        rung = diagnosis.rung();
        List<SensorHealth> health = diagnosis.health();
        diagnosed |= !health.isEmpty();
        for (SensorHealth sensor : health) {
            if (!sensor.isTrusted()) {
                distrust(sensor.sensor(), simulation.time(), simulation.robot());
            }
        }
    }

    private void distrust(String sensor, double time, RobotSpec robot) {
        if (!faulty.contains(sensor)
                && robot.sensor(sensor).filter(spec -> spec.on()).isPresent()) {
            wronglyDistrusted.add(sensor);
        }
        if (Double.isNaN(detected) && time >= onset && firstFaulty.equals(sensor)) {
            detected = time;
        }
    }

    /** {@return the time from the first fault until its sensor is not trusted, seconds; empty if it always is} */
    public OptionalDouble detectionDelay() {
        return Double.isNaN(detected) ? OptionalDouble.empty() : OptionalDouble.of(detected - onset);
    }

    /**
     * {@return the number of sensors without any fault that were not trusted at some time; empty without a diagnosis}
     */
    public OptionalInt falseAlarms() {
        return diagnosed ? OptionalInt.of(wronglyDistrusted.size()) : OptionalInt.empty();
    }

    /** {@return the name of the strategy that drove last, empty without a diagnosis} */
    public String rung() {
        return rung;
    }
}
