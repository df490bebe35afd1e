package faultline.gui.text;

import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.sensor.FaultDescriptor;
import java.util.List;
import java.util.stream.Collectors;

/** Describes the faults of sensors and motors in the user's language. */
public final class FaultText {

    /** The pattern of the numbers of faults, in texts and in fields. */
    public static final String NUMBER_PATTERN = "0.00##";

    private static final String DEGREES = "°";

    private FaultText() {}

    /** Returns the name of a side's motors. */
    public static String motors(MotorSide side) {
        return Messages.get("motors." + side.fileName());
    }

    /** Returns the name of a kind of fault. */
    public static String nameOf(FaultDescriptor<?> kind) {
        return Messages.get(keyOf(kind));
    }

    /** Returns a sentence that says what a kind of fault does. */
    public static String describe(FaultDescriptor<?> kind) {
        return Messages.get(keyOf(kind) + ".tip");
    }

    /** Returns the key of the text that says what the number of a kind of fault means, and its unit. */
    public static String valueKeyOf(FaultDescriptor<?> kind) {
        return kind.takesValue() ? keyOf(kind) + ".value" : "faults.noValue";
    }

    private static String keyOf(FaultDescriptor<?> kind) {
        return (kind instanceof MotorFaultKind ? "motorFault." : "fault.") + kind.fileName();
    }

    /** Formats the faults of a sensor. */
    public static String format(List<Fault> faults) {
        return faults.stream().map(FaultText::format).collect(Collectors.joining(", "));
    }

    /** Formats a fault of a sensor, for example "stuck 0.40 m". */
    public static String format(Fault fault) {
        String text = format(nameOf(fault.kind()), fault.kind(), fault.value());
        return fault.kind().takesLength()
                ? Messages.get("faults.withLength", text, NumberText.ofPattern(NUMBER_PATTERN, fault.length()))
                : text;
    }

    /** Formats a fault of motors, for example "weak 0.70". */
    public static String format(MotorFault fault) {
        return format(nameOf(fault.kind()), fault.kind(), fault.value());
    }

    /** Formats a fault with a name and a number, which kinds without one ignore. */
    public static String format(String name, FaultDescriptor<?> kind, double value) {
        if (!kind.takesValue()) {
            return name;
        }
        String number = NumberText.ofPattern(NUMBER_PATTERN, value);
        boolean sign = unitOf(kind).equals(DEGREES);
        return (name + " " + number + (sign ? "" : " ") + unitOf(kind)).strip();
    }

    /**
     * Returns the unit beside a field for the number of a kind of fault, or what a number from 0 to 1 is a share of.
     */
    public static String fieldUnitOf(FaultDescriptor<?> kind) {
        boolean share = kind.unit().isEmpty() && kind.maxValue() == 1;
        return share
                ? Messages.get(kind instanceof MotorFaultKind ? "motorFault.share" : "faults.share")
                : unitOf(kind);
    }

    /** Returns the unit of the number of a kind of fault, with a sign for degrees. */
    public static String unitOf(FaultDescriptor<?> kind) {
        return kind.unit().equals("deg") ? DEGREES : kind.unit();
    }
}
