package faultline.gui.batch;

import faultline.gui.text.Messages;

/** Formats a duration as text with the precision of an estimate. */
final class DurationText {

    private static final double MINUTE = 60;
    private static final double HOUR = 3600;

    /** The number of a unit below which the smaller unit is used. */
    private static final double FEW = 2;

    private DurationText() {}

    /** Returns a time in seconds, minutes or hours. */
    static String text(double seconds) {
        if (seconds < FEW * MINUTE) {
            return Messages.get("batch.seconds", Long.toString(Math.round(seconds)));
        }
        return seconds < FEW * HOUR
                ? Messages.get("batch.minutes", Long.toString(Math.round(seconds / MINUTE)))
                : Messages.get("batch.hours", Long.toString(Math.round(seconds / HOUR)));
    }
}
