package faultline.gui.instrument;

import faultline.engine.recording.TraceChannels;
import faultline.gui.text.Messages;
import faultline.paint.surface.DashPattern;
import faultline.world.SensorSnapshot;
import java.util.ArrayList;
import java.util.List;

/**
 * A choice of a strip chart: lines that are shown together.
 *
 * @param name the name of the choice
 * @param unit the unit of all lines
 * @param lines the lines from back to front
 */
record SignalGroup(String name, String unit, List<ChartLine> lines) {

    SignalGroup {
        lines = List.copyOf(lines);
    }

    /** Returns all groups for a robot with the given sensors. */
    static List<SignalGroup> allOf(List<SensorSnapshot> sensors) {
        List<SignalGroup> signals = new ArrayList<>();
        signals.add(pair("distance", "m", TraceChannels.MEASURED_DISTANCE, TraceChannels.WANTED_DISTANCE));
        signals.add(pair("terms", "rad/s", TraceChannels.PROPORTIONAL, TraceChannels.DERIVATIVE));
        signals.add(pair("volts", "V", TraceChannels.LEFT_VOLTS, TraceChannels.RIGHT_VOLTS));
        for (int i = 0; i < sensors.size(); i++) {
            signals.add(sensor(sensors.get(i).spec().id(), i));
        }
        return signals;
    }

    private static SignalGroup pair(String key, String unit, int first, int second) {
        String texts = "signal." + key;
        return new SignalGroup(
                Messages.get(texts),
                unit,
                List.of(
                        ChartLine.seriesLine(Messages.get(texts + ".second"), second, 1, DashPattern.DASHED),
                        ChartLine.seriesLine(Messages.get(texts + ".first"), first, 0, DashPattern.SOLID)));
    }

    private static SignalGroup sensor(String id, int index) {
        ChartLine truth = new ChartLine(
                Messages.get("signal.sensor.truth"),
                TraceChannels.trueReading(index),
                theme -> theme.palette().text(),
                DashPattern.DOTTED);
        ChartLine reported = new ChartLine(
                Messages.get("signal.sensor.reported"),
                TraceChannels.reportedReading(index),
                theme -> theme.palette().sensorColours(index).outline(),
                DashPattern.SOLID);
        return new SignalGroup(Messages.get("signal.sensor", id), "m", List.of(reported, truth));
    }

    @Override
    public String toString() {
        return name;
    }
}
