package faultline.engine.metrics;

import faultline.control.SensorHealth;
import faultline.engine.Simulation;
import faultline.io.MessageText;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The cells that a trace of format 2 has of one sensor: readings, faults, and what the diagnosis thinks of it. */
final class SensorCells implements TraceCells {

    private final int sensor;
    private final List<TraceColumn> columns;

    private List<Fault> lastFaults = List.of();
    private String faultText = "";

    private SensorHealth lastHealth;
    private String trustText = "";
    private String findingText = "";

    /**
     * Creates the cells of a sensor.
     *
     * @param sensor its place in the robot's list
     * @param id of it
     */
    SensorCells(int sensor, String id) {
        this.sensor = sensor;
        String cell = MessageText.cell(id);
        columns = List.of(
                new TraceColumn(cell + ".true", "m", "distance without noise and faults, empty for nothing in range"),
                new TraceColumn(cell + ".reading", "m", "reported distance, empty for nothing in range or no answer"),
                new TraceColumn(cell + ".answers", "", "1 if the sensor answers, 0 if it is off"),
                new TraceColumn(cell + ".faults", "", "active faults, oldest first"),
                new TraceColumn(cell + ".trust", "", "trusted, suspected or distrusted; empty without a diagnosis"),
                new TraceColumn(cell + ".finding", "", "why it is not trusted"),
                new TraceColumn(cell + ".evidence", "", "evidence against it, 0 to 1"));
    }

    @Override
    public List<TraceColumn> columns() {
        return columns;
    }

    @Override
    public void append(Simulation simulation, TraceRows rows) {
        double reading = simulation.reportedReading(sensor);
        rows.append(simulation.trueReading(sensor));
        rows.append(reading);
        rows.append(Reading.isOff(reading) ? "0" : "1");
        List<Fault> active = simulation.faults(sensor);
        // The comparison of two empty lists takes as long as all other cells.
        if (!(active.isEmpty() && lastFaults.isEmpty()) && !active.equals(lastFaults)) {
            lastFaults = List.copyOf(active);
            faultText = text(lastFaults);
        }
        rows.append(faultText);
        List<SensorHealth> health = simulation.telemetry().diagnosis().health();
        if (health.isEmpty()) {
            rows.append("");
            rows.append("");
            rows.append("");
        } else {
            appendHealth(health.get(sensor), rows);
        }
    }

    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    private void appendHealth(SensorHealth health, TraceRows rows) {
        if (health != lastHealth) {
            lastHealth = health;
            trustText = health.trust().name().toLowerCase(Locale.ROOT);
            findingText = health.finding().name().toLowerCase(Locale.ROOT);
        }
        rows.append(trustText);
        rows.append(findingText);
        rows.append(health.evidence());
    }

    /** Returns faults as words, such as {@code stuck=0.4 noise=0.01}. */
    private static String text(List<Fault> faults) {
        return faults.stream()
                .map(fault -> fault.kind().fileName() + (fault.kind().takesValue() ? "=" + fault.value() : ""))
                .collect(Collectors.joining(" "));
    }
}
