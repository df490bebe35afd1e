package faultline.engine.metrics;

import faultline.control.SensorHealth;
import faultline.control.Telemetry;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.world.Command;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Compares the findings of a controller's diagnosis with the actual faults of the sensors. A sensor that is distrusted
 * before its own first fault is a false alarm. In the tick of a fault, the diagnosis is still that of the readings
 * before it. A sensor that the diagnosis stopped trusting while it was off is no false alarm, also when it is on again.
 * What follows the tick of a contact does not count, because the robot then stands still, whatever its controller
 * believes.
 */
public final class DiagnosisMetrics implements TickObserver {

    private final double onset;
    private final long onsetTick;
    /** The ticks of the first fault of each sensor that has one, without those that end in their tick. */
    private final Map<String, Long> faultTicks = new HashMap<>();

    private final String firstFaulty;
    private final Set<String> wronglyDistrusted = new HashSet<>();
    /** The sensors that have not been trusted since they were off. */
    private final Set<String> rightlyDistrusted = new HashSet<>();
    /** The length of a tick, seconds. */
    private final double dt;

    /** The robot at the last observation. */
    private RobotSpec before;
    /** Whether the sensor that fails first was trusted at the last observation. */
    private boolean trusted = true;

    private double detected = Double.NaN;
    private double secondsInView;
    private double largestError;
    private String rung = "";
    private boolean diagnosed;
    /** Whether there was a contact at the last observation. */
    private boolean collided;

    /**
     * Creates metrics of one run of a setup.
     *
     * @param setup the setup of the run
     */
    public DiagnosisMetrics(SimulationSetup setup) {
        dt = setup.dt();
        before = setup.robot();
        List<SimulationSetup.TimedCommand> faults = FaultStarts.of(setup);
        onset = faults.stream()
                .mapToDouble(timed -> CarryOnMetrics.startTime(setup, timed))
                .min()
                .orElse(0);
        onsetTick = setup.tickAt(onset);
        for (SimulationSetup.TimedCommand timed : faults) {
            if (timed.command() instanceof Command.InjectFault fault) {
                faultTicks.merge(fault.sensor(), setup.tickAt(timed.time()), Math::min);
            }
        }
        firstFaulty = faults.stream()
                .filter(timed -> CarryOnMetrics.startTime(setup, timed) == onset
                        && timed.command() instanceof Command.InjectFault)
                .map(timed -> ((Command.InjectFault) timed.command()).sensor())
                .filter(sensor -> setup.robot().sensor(sensor).isPresent())
                .findFirst()
                .orElse("");
    }

    @Override
    public void observe(Simulation simulation) {
        Telemetry.Diagnosis diagnosis = simulation.telemetry().diagnosis();
        rung = diagnosis.rung();
        List<SensorHealth> health = diagnosis.health();
        diagnosed |= !health.isEmpty();
        if (collided) {
            return;
        }
        collided = simulation.collision().isPresent();
        if (!firstFaulty.isEmpty() && Double.isNaN(detected) && simulation.time() >= onset) {
            measureFault(simulation);
        }
        boolean wasTrusted = trusted;
        trusted = true;
        for (SensorHealth sensor : health) {
            if (sensor.isTrusted()) {
                rightlyDistrusted.remove(sensor.sensor());
            } else {
                distrust(sensor.sensor(), simulation);
            }
        }
        before = simulation.robot();
        if (Double.isNaN(detected) && wasTrusted && !trusted && simulation.ticks() > onsetTick) {
            detected = simulation.time();
        }
    }

    /** Measures how far the sensor that fails first is wrong, as long as a surface is within its range. */
    private void measureFault(Simulation simulation) {
        int sensor = simulation.robot().indexOf(firstFaulty);
        double distance = simulation.trueReading(sensor);
        if (distance == Reading.NOTHING) {
            return;
        }
        secondsInView += dt;
        double reading = simulation.reportedReading(sensor);
        if (reading < Reading.NOTHING) {
            largestError = Math.max(largestError, Math.abs(reading - distance));
        }
    }

    private void distrust(String sensor, Simulation simulation) {
        trusted &= !sensor.equals(firstFaulty);
        if (simulation.ticks() > faultTicks.getOrDefault(sensor, Long.MAX_VALUE)
                || wronglyDistrusted.contains(sensor)
                || rightlyDistrusted.contains(sensor)) {
            return;
        }
        // The diagnosis is still that of the readings of the last tick.
        boolean isOn = isOn(sensor, before) && isOn(sensor, simulation.robot());
        (isOn ? wronglyDistrusted : rightlyDistrusted).add(sensor);
    }

    private static boolean isOn(String sensor, RobotSpec robot) {
        return robot.sensor(sensor).filter(spec -> spec.on()).isPresent();
    }

    /**
     * {@return the time from the first fault until its sensor is no longer trusted, seconds; empty if it is until the
     * end or a contact, if it was not trusted before and never is again, or if the first fault is one of motors}
     */
    public OptionalDouble detectionDelay() {
        return Double.isNaN(detected) ? OptionalDouble.empty() : OptionalDouble.of(detected - onset);
    }

    /**
     * {@return the time with a surface within the range of the sensor, so that a fault could be seen, from the tick of
     * the first fault to that of its detection, both included, seconds; empty without a {@link #detectionDelay}} It can
     * be longer than the delay by one tick.
     */
    public OptionalDouble secondsInView() {
        return Double.isNaN(detected) ? OptionalDouble.empty() : OptionalDouble.of(secondsInView);
    }

    /**
     * {@return the largest difference between a reading and the distance from the tick of the first fault to that of
     * its detection, both included, metres; empty without a {@link #detectionDelay}}
     */
    public OptionalDouble errorBeforeDetection() {
        return Double.isNaN(detected) ? OptionalDouble.empty() : OptionalDouble.of(largestError);
    }

    /**
     * {@return the number of sensors that the diagnosis stopped trusting before any fault of theirs and any contact,
     * while they were on; empty without a diagnosis}
     */
    public OptionalInt falseAlarms() {
        return diagnosed ? OptionalInt.of(wronglyDistrusted.size()) : OptionalInt.empty();
    }

    /** {@return the name of the strategy that drove last, also after a contact; empty without a diagnosis} */
    public String rung() {
        return rung;
    }
}
