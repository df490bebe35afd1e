package faultline.gui.text;

import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import java.util.Locale;

/** The faults of motors in the user's language. */
public final class MotorFaultText {

    private MotorFaultText() {}

    /** Returns the name of a side's motors. */
    public static String motors(MotorSide side) {
        return Messages.get("motors." + side.fileName());
    }

    /** Formats a fault, for example "weak 0.70". */
    public static String format(MotorFault fault) {
        String kind = Messages.get("motorFault." + fault.kind().fileName());
        return fault.kind().takesValue()
                ? (kind
                                + String.format(Locale.ROOT, " %.2f ", fault.value())
                                + fault.kind().unit())
                        .strip()
                : kind;
    }
}
