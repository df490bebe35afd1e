package faultline.robot;

/**
 * A first-order motor with its wheel.
 *
 * @param timeConstant tau, seconds, 0 for a motor without lag
 * @param speedConstant the wheel's rim speed per volt, metres per second, positive
 * @param maxVoltage the saturation of the supply, volts, positive
 */
public record MotorSpec(double timeConstant, double speedConstant, double maxVoltage) {

    /** The motor if none is given: 50 ms, 0.1 m/s per volt, 6 V. */
    public static final MotorSpec DEFAULT = new MotorSpec(0.05, 0.1, 6);

    /**
     * Creates a motor.
     *
     * @param timeConstant tau, seconds, 0 for a motor without lag
     * @param speedConstant the wheel's rim speed per volt, metres per second, positive
     * @param maxVoltage the saturation of the supply, volts, positive
     * @throws IllegalArgumentException if a value is not finite, negative, or 0 where it must be positive
     */
    public MotorSpec {
        if (!(timeConstant >= 0 && Double.isFinite(timeConstant))) {
            throw new IllegalArgumentException("the motor's time constant must not be negative: " + timeConstant);
        }
        if (!(speedConstant > 0 && Double.isFinite(speedConstant))) {
            throw new IllegalArgumentException("the motor's speed constant must be positive: " + speedConstant);
        }
        if (!(maxVoltage > 0 && Double.isFinite(maxVoltage))) {
            throw new IllegalArgumentException("the motor's maximum voltage must be positive: " + maxVoltage);
        }
    }

    /** {@return the maximum wheel speed, metres per second} */
    public double maxSpeed() {
        return speedConstant * maxVoltage;
    }

    /**
     * {@return this motor with wheels that turn faster or slower by a factor}
     *
     * @param factor the factor of the wheel speed, positive
     */
    public MotorSpec scaled(double factor) {
        return factor == 1 ? this : new MotorSpec(timeConstant, factor * speedConstant, maxVoltage);
    }

    /**
     * {@return a voltage limited to the supply}
     *
     * @param volts the voltage
     */
    public double limit(double volts) {
        return Math.max(-maxVoltage, Math.min(maxVoltage, volts));
    }

    /**
     * {@return the voltage, not limited, that holds a wheel speed given in metres per second}
     *
     * @param speed the wheel speed, in metres per second
     */
    public double voltageFor(double speed) {
        return speed / speedConstant;
    }

    /**
     * {@return the wheel speed, metres per second, at which the motor settles with a voltage}
     *
     * @param volts the voltage, limited to the supply
     */
    public double speedFor(double volts) {
        return speedConstant * limit(volts);
    }

    /**
     * {@return the fraction in [0, 1] of a speed error that remains after a tick of dt seconds: exp(-dt / tau)}
     *
     * @param dt the length of a tick, in seconds, positive
     */
    public double decay(double dt) {
        return timeConstant == 0 ? 0 : StrictMath.exp(-dt / timeConstant);
    }

    /**
     * {@return the wheel speed after a tick: the exact solution of tau dv/dt = speedConstant u - v for constant
     * voltage}
     *
     * @param speed the wheel speed before the tick, metres per second
     * @param volts the voltage during the tick, limited to the supply
     * @param decay from {@link #decay}
     */
    public double step(double speed, double volts, double decay) {
        double target = speedFor(volts);
        return target + (speed - target) * decay;
    }

    /**
     * {@return the speeds of both sides' wheels after a tick, each as {@link #step(double, double, double)} does}
     *
     * @param speeds the wheel speeds before the tick
     * @param leftVolts the voltage on the left motors during the tick
     * @param rightVolts the voltage on the right motors during the tick
     * @param decay the result of {@link #decay} for the tick
     */
    public WheelSpeeds step(WheelSpeeds speeds, double leftVolts, double rightVolts, double decay) {
        return new WheelSpeeds(step(speeds.left(), leftVolts, decay), step(speeds.right(), rightVolts, decay));
    }
}
