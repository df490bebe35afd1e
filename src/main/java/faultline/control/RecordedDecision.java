package faultline.control;

import faultline.io.XmlText;

/**
 * A decision of an earlier run. It holds until the next one of the record.
 *
 * @param tick the tick of the observation that was decided on
 * @param leftVolts the voltage on the left motors
 * @param rightVolts the voltage on the right motors
 * @param state the name of the controller's state; on one line
 * @param condition the condition that brought it there, empty if it gave none; on one line
 */
public record RecordedDecision(long tick, double leftVolts, double rightVolts, String state, String condition) {

    /**
     * Creates a record, with the state and the condition on one line each.
     *
     * @param tick the tick of the observation that was decided on
     * @param leftVolts the voltage on the left motors
     * @param rightVolts the voltage on the right motors
     * @param state the name of the controller's state; on one line
     * @param condition the condition that brought it there, empty if it gave none; on one line
     */
    public RecordedDecision {
        state = XmlText.oneLine(state);
        condition = XmlText.oneLine(condition);
    }

    /** Returns whether another decision differs from this one in anything but its tick. */
    boolean differs(Decision other) {
        return Double.doubleToLongBits(leftVolts) != Double.doubleToLongBits(other.leftVolts())
                || Double.doubleToLongBits(rightVolts) != Double.doubleToLongBits(other.rightVolts())
                || !state.equals(XmlText.oneLine(other.telemetry().state().name()))
                || !condition.equals(XmlText.oneLine(other.telemetry().condition()));
    }
}
