package faultline.robot;

/**
 * A first-order motor with its wheel.
 *
 * @param timeConstant tau, seconds, 0 for a motor that follows at once
 * @param speedConstant metres per second at the wheel's rim per volt, positive
 * @param maxVoltage the saturation of the supply, volts, positive
 */
public record MotorSpec(double timeConstant, double speedConstant, double maxVoltage) {

    /** The motor of a robot that is given none: 50 ms, 0.1 m/s per volt, 6 V. */
    public static final MotorSpec DEFAULT = new MotorSpec(0.05, 0.1, 6);

    public MotorSpec {
        if (!(timeConstant >= 0 && Double.isFinite(timeConstant))) {
            throw new IllegalArgumentException("the motor's time constant must not be negative: " + timeConstant);
        }
        if (!(speedConstant > 0 && Double.isFinite(speedConstant))) {
            throw new IllegalArgumentException("the motor's speed constant must be positive: " + speedConstant);
        }
        if (!(maxVoltage > 0 && Double.isFinite(maxVoltage))) {
            throw new IllegalArgumentException("the motor's greatest voltage must be positive: " + maxVoltage);
        }
    }

    /**
     * The fastest that the wheel can run.
     *
     * @return metres per second
     */
    public double maxSpeed() {
        return speedConstant * maxVoltage;
    }

    /**
     * The voltage that holds a wheel speed.
     *
     * @param speed metres per second
     * @return volts, not limited
     */
    public double voltageFor(double speed) {
        return speed / speedConstant;
    }

    /**
     * The share of a speed error that is left after one tick, exp(-dt / tau).
     *
     * @param dt the tick, seconds
     * @return in [0, 1)
     */
    public double decay(double dt) {
        return timeConstant == 0 ? 0 : StrictMath.exp(-dt / timeConstant);
    }

    /**
     * The wheel speed one tick on: the exact solution of tau dv/dt = speedConstant u - v for a constant voltage.
     *
     * @param speed the wheel speed now, metres per second
     * @param volts the voltage during the tick, limited to the supply
     * @param decay from {@link #decay}
     * @return metres per second
     */
    public double step(double speed, double volts, double decay) {
        double target = speedConstant * Math.max(-maxVoltage, Math.min(maxVoltage, volts));
        return target + (speed - target) * decay;
    }
}
