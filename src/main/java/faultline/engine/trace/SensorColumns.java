package faultline.engine.trace;

import faultline.control.SensorHealth;
import faultline.engine.Simulation;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The columns that a trace of format 2 has of the sensors: readings, faults, and the assessment by the diagnosis. */
final class SensorColumns implements ColumnGroup {

    /** The number of cells of a sensor after its two distances. */
    private static final int WORDS = 5;

    private final List<TraceColumn> columns = new ArrayList<>();
    private final SensorWords[] words;

    /** The words of one sensor in the row above, and the values from which they were made. */
    private static final class SensorWords {
        private boolean off;
        /** Null before the first row. */
        private List<Fault> faults;

        private String faultText = "";
        /** Null if it is unknown, as without a diagnosis. */
        private SensorHealth health;

        private String trust = "";
        private String finding = "";
    }

    SensorColumns(RobotSpec robot) {
        words = new SensorWords[robot.sensors().size()];
        for (int i = 0; i < words.length; i++) {
            words[i] = new SensorWords();
            addColumns(MessageText.cell(robot.sensors().get(i).id()));
        }
    }

    private void addColumns(String id) {
        columns.addAll(List.of(
                new TraceColumn(id + ".true", "m", "distance without noise and faults, empty for nothing in range"),
                new TraceColumn(id + ".reading", "m", "reported distance, empty for nothing in range or no answer"),
                new TraceColumn(id + ".answers", "", "1 if the sensor answers, 0 if it is off"),
                new TraceColumn(id + ".faults", "", "active faults, oldest first"),
                new TraceColumn(id + ".trust", "", "trusted, suspected or distrusted; empty without a diagnosis"),
                new TraceColumn(id + ".finding", "", "why it is not trusted"),
                new TraceColumn(id + ".evidence", "", "evidence against it, 0 to 1")));
    }

    @Override
    public List<TraceColumn> columns() {
        return columns;
    }

    @Override
    public void append(Simulation simulation, TraceRows rows) {
        List<SensorHealth> health = simulation.telemetry().diagnosis().health();
        for (int i = 0; i < words.length; i++) {
            double reading = simulation.reportedReading(i);
            rows.append(simulation.trueReading(i));
            rows.append(reading);
            append(
                    Reading.isOff(reading),
                    simulation.faults(i),
                    i < health.size() ? health.get(i) : null,
                    words[i],
                    rows);
        }
    }

    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    private static void append(
            boolean off, List<Fault> faults, SensorHealth health, SensorWords words, TraceRows rows) {
        if (off == words.off && health == words.health && faults == words.faults) {
            rows.repeat(WORDS);
            return;
        }
        if (!faults.equals(words.faults)) {
            words.faultText = FaultCell.ofSensor(faults);
        }
        words.faults = faults;
        if (health != words.health) {
            words.trust = health == null ? "" : health.trust().name().toLowerCase(Locale.ROOT);
            words.finding = health == null ? "" : health.finding().name().toLowerCase(Locale.ROOT);
        }
        words.off = off;
        words.health = health;
        rows.append(off ? "0" : "1");
        rows.append(words.faultText);
        rows.append(words.trust);
        rows.append(words.finding);
        if (health == null) {
            rows.append("");
        } else {
            rows.append(health.evidence());
        }
    }
}
