package faultline.gui.text;

import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.List;
import java.util.stream.Collectors;

/** Formats readings and faults. */
public final class ReadingText {

    private ReadingText() {}

    /** Returns the distance in metres, a dash if nothing is in range, or "off". */
    public static String format(Reading reading) {
        if (reading.isOff()) {
            return Messages.get("reading.off");
        }
        return reading.distance().isPresent() ? NumberText.format("%.3f", reading.encoded()) : "–";
    }

    /** Formats the faults of a sensor. */
    public static String format(List<Fault> faults) {
        return faults.stream().map(ReadingText::format).collect(Collectors.joining(", "));
    }

    /** Formats a fault, for example "stuck 0.40 m". */
    public static String format(Fault fault) {
        return MotorFaultText.format(MotorFaultText.nameOf(fault.kind()), fault.kind(), fault.value());
    }
}
