package faultline.robot;

import faultline.sensor.FaultDescriptor;
import java.util.function.DoubleFunction;

/**
 * The kinds of fault of motors with the names that scenario files use, each with the bounds of its number. A new kind
 * needs one line here and one record that {@link MotorFault} permits.
 */
public enum MotorFaultKind implements FaultDescriptor<MotorFault> {

    /** Part of the voltage has an effect; the number is that share. */
    WEAK("", 0, 1, 0.7, MotorFault.Weak::new),

    /** No voltage has an effect; no number. */
    DEAD("", 0, 0, 0, value -> new MotorFault.NoDrive()),

    /** Small voltages have no effect; the number is the greatest of them. */
    DEAD_BAND("V", 0, 10_000, 0.5, MotorFault.DeadBand::new);

    private final Parameter parameter;
    private final DoubleFunction<MotorFault> factory;

    MotorFaultKind(String unit, double least, double most, double initial, DoubleFunction<MotorFault> factory) {
        this.parameter = new Parameter(unit, least, most, initial);
        this.factory = factory;
    }

    @Override
    public Parameter parameter() {
        return parameter;
    }

    @Override
    public MotorFault createFault(double value, double length) {
        return factory.apply(value);
    }
}
