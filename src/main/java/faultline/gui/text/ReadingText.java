package faultline.gui.text;

import faultline.sensor.Reading;

/** Formats readings. */
public final class ReadingText {

    private ReadingText() {}

    /** Returns the distance in metres, a dash if nothing is in range, or "off". */
    public static String format(Reading reading) {
        if (reading.isOff()) {
            return Messages.get("reading.off");
        }
        return reading.distance().isPresent() ? NumberText.format("%.3f", reading.encoded()) : "–";
    }
}
