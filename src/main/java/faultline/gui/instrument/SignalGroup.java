package faultline.gui.instrument;

import faultline.engine.recording.TraceChannels;
import faultline.gui.text.Messages;
import faultline.paint.surface.DashPattern;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * A choice of a strip chart: lines that are shown together, from back to front, and their unit.
 *
 * @param id what distinguishes it from other choices, in any language and for any robot
 * @param name its name in the current language
 * @param unit the unit of its lines
 * @param lines the lines
 */
record SignalGroup(String id, String name, String unit, List<ChartLine> lines) {

    /** A choice without lines. */
    static final SignalGroup NONE = new SignalGroup("", "", "", List.of());

    private static final String DISTANCE_ID = "distance";
    private static final String SENSOR_ID = "sensor ";
    private static final double DEGREES_PER_RADIAN = 180 / Math.PI;

    SignalGroup {
        lines = List.copyOf(lines);
    }

    /** Returns all groups for a robot with the given sensors. */
    static List<SignalGroup> allOf(List<String> sensors) {
        List<SignalGroup> signals = new ArrayList<>();
        signals.add(distance());
        signals.add(pair("terms", "rad/s", TraceChannels.PROPORTIONAL, TraceChannels.DERIVATIVE));
        signals.add(pair("volts", "V", TraceChannels.LEFT_VOLTS, TraceChannels.RIGHT_VOLTS));
        signals.add(motion("velocity", "m/s", 1, TraceChannels.VELOCITY, TraceChannels.COMMANDED_VELOCITY));
        signals.add(motion(
                "turnRate", "°/s", DEGREES_PER_RADIAN, TraceChannels.TURN_RATE, TraceChannels.COMMANDED_TURN_RATE));
        for (int i = 0; i < sensors.size(); i++) {
            signals.add(sensor(sensors.get(i), i));
        }
        return signals;
    }

    /** Returns the lines of other groups that can be shown in the same chart, named after their groups. */
    static List<ChartLine> additions(SignalGroup shown, List<SignalGroup> all) {
        return all.stream()
                .filter(other ->
                        other.unit().equals(shown.unit()) && !other.id().equals(shown.id()))
                .flatMap(other -> other.lines().stream().map(line -> line.withName(other.name() + ", " + line.name())))
                .toList();
    }

    /** Returns whether this is the distance that the controller reports. */
    boolean isDistance() {
        return id.equals(DISTANCE_ID);
    }

    /** Returns whether a robot with the given sensors has a value for any line. */
    boolean hasLineIn(List<String> sensors) {
        return lines.stream().anyMatch(line -> line.channelIn(sensors).isPresent());
    }

    /** Returns this group with further lines behind its own. */
    SignalGroup with(List<ChartLine> additions) {
        List<ChartLine> all = new ArrayList<>(additions);
        all.addAll(lines);
        return new SignalGroup(id, name, unit, all);
    }

    /** Returns this group for sensors that are called otherwise, given what returns their ids for those before. */
    SignalGroup withSensor(UnaryOperator<String> presentId) {
        String newId = lines.stream()
                .map(ChartLine::sensor)
                .filter(sensor -> id.equals(SENSOR_ID + sensor))
                .map(sensor -> SENSOR_ID + presentId.apply(sensor))
                .findFirst()
                .orElse(id);
        return new SignalGroup(
                newId,
                name,
                unit,
                lines.stream().map(line -> line.withSensor(presentId)).toList());
    }

    /** Returns the distance that the controller uses, which is a reading or that of its local map, and its target. */
    private static SignalGroup distance() {
        ChartLine measured = new ChartLine(
                Messages.get("signal.distance.first"),
                "",
                TraceChannels.MEASURED_DISTANCE,
                theme -> theme.palette().path(),
                DashPattern.SOLID);
        ChartLine target = new ChartLine(
                Messages.get("signal.distance.second"),
                "",
                TraceChannels.WANTED_DISTANCE,
                theme -> theme.palette().text(),
                DashPattern.DASHED);
        return new SignalGroup(DISTANCE_ID, Messages.get("signal.distance"), "m", List.of(target, measured));
    }

    private static SignalGroup pair(String key, String unit, int first, int second) {
        String texts = "signal." + key;
        return new SignalGroup(
                key,
                Messages.get(texts),
                unit,
                List.of(
                        new ChartLine(
                                Messages.get(texts + ".second"),
                                "",
                                second,
                                theme -> theme.palette().text(),
                                DashPattern.DASHED),
                        new ChartLine(
                                Messages.get(texts + ".first"),
                                "",
                                first,
                                theme -> theme.palette().path(),
                                DashPattern.SOLID)));
    }

    /** Returns the actual and the commanded value of a velocity, given the factor from its channels to its unit. */
    private static SignalGroup motion(String key, String unit, double factor, int actual, int commanded) {
        ChartLine front = new ChartLine(
                Messages.get("signal.motion.actual"),
                "",
                actual,
                factor,
                theme -> theme.palette().accent(),
                DashPattern.SOLID);
        ChartLine back = new ChartLine(
                Messages.get("signal.motion.commanded"),
                "",
                commanded,
                factor,
                theme -> theme.palette().muted(),
                DashPattern.DASH_DOT);
        return new SignalGroup(key, Messages.get("signal." + key), unit, List.of(back, front));
    }

    private static SignalGroup sensor(String id, int index) {
        ChartLine truth = new ChartLine(
                Messages.get("signal.sensor.truth"),
                id,
                TraceChannels.trueReading(0),
                theme -> theme.palette().sensorColours(index).outline(),
                DashPattern.DOTTED);
        ChartLine reported = new ChartLine(
                Messages.get("signal.sensor.reported"),
                id,
                TraceChannels.reportedReading(0),
                theme -> theme.palette().sensorColours(index).outline(),
                DashPattern.SOLID);
        return new SignalGroup(SENSOR_ID + id, Messages.get("signal.sensor", id), "m", List.of(reported, truth));
    }

    @Override
    public String toString() {
        return name;
    }
}
