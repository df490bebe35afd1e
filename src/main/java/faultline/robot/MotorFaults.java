package faultline.robot;

import faultline.sensor.FaultSequence;
import java.util.List;

/**
 * The faults that the motors have, for each side in the order in which they act.
 *
 * @param left the faults of the left motors
 * @param right the faults of the right motors
 */
public record MotorFaults(List<MotorFault> left, List<MotorFault> right) {

    /** No faults. */
    public static final MotorFaults NONE = new MotorFaults(List.of(), List.of());

    /**
     * Creates faults from copies of two lists.
     *
     * @param left the faults of the left motors
     * @param right the faults of the right motors
     */
    public MotorFaults {
        left = FaultSequence.copyOf(left);
        right = FaultSequence.copyOf(right);
    }

    /**
     * {@return the faults of a side}
     *
     * @param side the side of the motors
     */
    public List<MotorFault> of(MotorSide side) {
        return side == MotorSide.LEFT ? left : right;
    }

    /**
     * {@return these faults with others on one side}
     *
     * @param side the side of the motors
     * @param faults the new faults of that side, in the order in which they apply
     */
    public MotorFaults with(MotorSide side, List<MotorFault> faults) {
        return side == MotorSide.LEFT ? new MotorFaults(faults, right) : new MotorFaults(left, faults);
    }

    /**
     * {@return the voltage that has an effect on a side's motors}
     *
     * @param side the side of the motors
     * @param volts the voltage that is applied
     */
    public double apply(MotorSide side, double volts) {
        double effective = volts;
        List<MotorFault> faults = of(side);
        for (int i = 0; i < faults.size(); i++) {
            effective = faults.get(i).apply(effective);
        }
        return effective;
    }
}
