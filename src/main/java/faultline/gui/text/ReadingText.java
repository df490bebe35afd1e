package faultline.gui.text;

import faultline.sensor.Reading;

/** Formats readings. */
public final class ReadingText {

    private static final int SHORT_LENGTH = 5;

    private ReadingText() {}

    /** Returns the distance in metres, a dash if nothing is in range, or "off". */
    public static String format(Reading reading) {
        if (reading.isOff()) {
            return Messages.get("reading.off");
        }
        return reading.distance().isPresent() ? format(reading, 3) : "–";
    }

    /** Returns {@link #format} with as many decimals as five characters have room for. */
    public static String formatShort(Reading reading) {
        String text = format(reading);
        for (int decimals = 2; decimals >= 0 && text.length() > SHORT_LENGTH; decimals--) {
            text = format(reading, decimals);
        }
        return text;
    }

    private static String format(Reading reading, int decimals) {
        return NumberText.format("%." + decimals + "f", reading.encoded());
    }
}
