package faultline.gui.text;

import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.sensor.FaultDescriptor;
import java.util.Locale;

/** The faults of motors in the user's language. */
public final class MotorFaultText {

    private MotorFaultText() {}

    /** Returns the name of a side's motors. */
    public static String motors(MotorSide side) {
        return Messages.get("motors." + side.fileName());
    }

    /** Returns the name of a kind of fault. */
    public static String nameOf(MotorFaultKind kind) {
        return Messages.get("motorFault." + kind.fileName());
    }

    /** Formats a fault, for example "weak 0.70". */
    public static String format(MotorFault fault) {
        return format(nameOf(fault.kind()), fault.kind(), fault.value());
    }

    /** Formats a fault with a name and a number, which kinds without one ignore. */
    public static String format(String name, FaultDescriptor<?> kind, double value) {
        return kind.takesValue() ? (name + String.format(Locale.ROOT, " %.2f ", value) + unitOf(kind)).strip() : name;
    }

    /** Returns the unit of the number of a kind of fault, with a sign for degrees. */
    public static String unitOf(FaultDescriptor<?> kind) {
        return kind.unit().equals("deg") ? "°" : kind.unit();
    }
}
