package faultline.engine.metrics;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.geometry.Angles;
import faultline.io.MessageText;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;

/**
 * Writes the trace as CSV: a header, and a row for tick 0 and each later tick. Every number is the shortest text that
 * reads back to the same bits.
 */
public final class TraceWriter implements TickObserver {

    private final Writer out;
    private boolean headerWritten;

    /** Creates a trace on a buffered writer, which the caller closes. */
    public TraceWriter(Writer out) {
        this.out = out;
    }

    /**
     * Writes the row of the current tick.
     *
     * @throws UncheckedIOException if the writer fails
     */
    @Override
    public void observe(Simulation simulation) {
        StringBuilder row = new StringBuilder(256);
        if (!headerWritten) {
            appendHeader(simulation, row);
            headerWritten = true;
        }
        appendMotion(simulation, row);
        for (int i = 0; i < simulation.robot().sensors().size(); i++) {
            row.append(',')
                    .append(readingCell(simulation.trueReading(i)))
                    .append(',')
                    .append(readingCell(simulation.reportedReading(i)));
        }
        write(row.append('\n'));
    }

    private static void appendHeader(Simulation simulation, StringBuilder row) {
        row.append("tick,t,x,y,heading_deg,v,omega,left_v,right_v,state,collided");
        for (SensorSpec sensor : simulation.robot().sensors()) {
            String name = MessageText.cell(sensor.id());
            row.append(',').append(name).append(".true,").append(name).append(".reading");
        }
        row.append('\n');
    }

    private static void appendMotion(Simulation s, StringBuilder row) {
        double heading = StrictMath.toDegrees(Angles.normalize(s.pose().heading()));
        row.append(s.ticks())
                .append(',')
                .append(s.time())
                .append(',')
                .append(s.pose().x())
                .append(',')
                .append(s.pose().y())
                .append(',')
                .append(heading)
                .append(',')
                .append(s.velocity().linear())
                .append(',')
                .append(s.velocity().angular())
                .append(',')
                .append(s.wheelSpeeds().left())
                .append(',')
                .append(s.wheelSpeeds().right())
                .append(',')
                .append(s.telemetry().state())
                .append(',')
                .append(s.collision().isPresent());
    }

    private static String readingCell(double reading) {
        if (Reading.isOff(reading)) {
            return "off";
        }
        return reading == Reading.NOTHING ? "" : Double.toString(reading);
    }

    private void write(CharSequence text) {
        try {
            out.append(text);
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }
}
