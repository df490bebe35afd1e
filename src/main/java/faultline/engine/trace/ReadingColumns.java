package faultline.engine.trace;

import faultline.engine.Simulation;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** The columns that a trace of format 1 has of the sensors. */
final class ReadingColumns implements ColumnGroup {

    private final List<TraceColumn> columns = new ArrayList<>();
    private final int sensors;

    ReadingColumns(RobotSpec robot) {
        sensors = robot.sensors().size();
        for (SensorSpec sensor : robot.sensors()) {
            String id = MessageText.cell(sensor.id());
            columns.add(new TraceColumn(id + ".true", "", ""));
            columns.add(new TraceColumn(id + ".reading", "", ""));
        }
    }

    @Override
    public List<TraceColumn> columns() {
        return columns;
    }

    @Override
    public void append(Simulation simulation, TraceRows rows) {
        for (int i = 0; i < sensors; i++) {
            append(simulation.trueReading(i), rows);
            append(simulation.reportedReading(i), rows);
        }
    }

    private static void append(double reading, TraceRows rows) {
        if (Reading.isOff(reading)) {
            rows.append("off");
        } else {
            rows.append(reading);
        }
    }
}
