package faultline.engine.metrics;

import faultline.engine.Simulation;
import faultline.io.MessageText;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;

/** The cells that a trace of format 1 has of the sensors. */
final class ReadingCells implements TraceCells {

    private final List<TraceColumn> columns = new ArrayList<>();
    /** One for both cells of a sensor, which are equal unless there is noise or a fault. */
    private final List<NumberText> numbers = new ArrayList<>();

    ReadingCells(RobotSpec robot) {
        robot.sensors().forEach(sensor -> {
            String id = MessageText.cell(sensor.id());
            columns.add(new TraceColumn(id + ".true", "", ""));
            columns.add(new TraceColumn(id + ".reading", "", ""));
            numbers.add(new NumberText());
        });
    }

    @Override
    public List<TraceColumn> columns() {
        return columns;
    }

    @Override
    public void append(Simulation simulation, TraceBlock row) {
        for (int i = 0; i < numbers.size(); i++) {
            append(simulation.trueReading(i), numbers.get(i), row);
            append(simulation.reportedReading(i), numbers.get(i), row);
        }
    }

    private static void append(double reading, NumberText number, TraceBlock row) {
        if (Double.isFinite(reading)) {
            number.appendCell(reading, row);
            return;
        }
        if (Reading.isOff(reading)) {
            row.append("off");
        }
        row.endCell();
    }
}
