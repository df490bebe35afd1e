package faultline.sensor;

import java.util.Arrays;

/**
 * The inputs and the state of one active fault: the tick, the sensor's random numbers, and what the fault remembers
 * since it began. Mutable; confined to the simulation thread. A fault that is applied twice in one tick gives the same
 * reading.
 */
public final class FaultContext {

    /** The history of the faults that remember nothing, which are most. */
    private static final double[] NO_HISTORY = new double[0];

    private final long onset;
    private final double dt;
    private final double heldReading;
    private long tick;
    private double range;
    private double neighbourReading;
    private SensorRandom random;
    private double[] history = NO_HISTORY;
    private long nextStored;
    private boolean inBurst;
    private long burstTick;

    /**
     * Creates the context of a fault that begins.
     *
     * @param onset the first tick in which it acts
     * @param dt the length of a tick, seconds
     * @param heldReading the last reported reading; nothing if there was none
     */
    public FaultContext(long onset, double dt, double heldReading) {
        this.onset = onset;
        this.dt = dt;
        this.heldReading = heldReading;
        this.burstTick = onset - 1;
    }

    /** {@return a context in the same state, which changes independently} */
    public FaultContext copy() {
        FaultContext copy = new FaultContext(onset, dt, heldReading);
        copy.history = history.clone();
        copy.nextStored = nextStored;
        copy.inBurst = inBurst;
        copy.burstTick = burstTick;
        return copy;
    }

    /**
     * Advances to a tick and returns this context.
     *
     * @param newTick the tick
     * @param newRange the sensor's range at this tick, metres
     * @param newNeighbourReading the reading of the next sensor at this tick, without faults
     * @param draws the sensor's random numbers for this tick
     * @return this context
     */
    public FaultContext at(long newTick, double newRange, double newNeighbourReading, SensorRandom draws) {
        tick = newTick;
        range = newRange;
        neighbourReading = newNeighbourReading;
        random = draws;
        return this;
    }

    double range() {
        return range;
    }

    SensorRandom random() {
        return random;
    }

    double neighbourReading() {
        return neighbourReading;
    }

    double heldReading() {
        return heldReading;
    }

    /** Returns how long the fault has lasted, seconds. */
    double age() {
        return (tick - onset) * dt;
    }

    /**
     * Stores a reading, and returns the one of an earlier time, or the first one if the fault is younger; nothing if
     * there was none at that time because the sensor did not answer.
     */
    double delayed(double reading, double seconds) {
        long now = tick - onset;
        long delay = Math.round(seconds / dt);
        int size = (int) delay + 1;
        // A long delay in short ticks needs megabytes, but only after as many ticks.
        int used = (int) Math.min(size, now + 1);
        if (history.length < used) {
            history = Arrays.copyOf(history, Math.min(size, Math.max(64, 2 * used)));
        }
        for (long i = Math.max(nextStored, now - delay); i < now; i++) {
            history[(int) (i % size)] = Reading.NOTHING;
        }
        history[(int) (now % size)] = reading;
        nextStored = now + 1;
        return history[(int) (Math.max(0, now - delay) % size)];
    }

    /**
     * Returns whether there is a burst now: bursts begin at a rate, at most in each tick, and end after a mean length,
     * at least one tick, also while the sensor is off and its faults are not applied.
     */
    boolean inBurst(double rate, double length) {
        double uniform = random.nextDouble();
        if (tick != burstTick) {
            double begins = Math.min(1, rate * dt);
            double ends = Math.min(1, dt / length);
            double steps = severalSteps(begins + ends, tick - burstTick);
            inBurst = inBurst ? uniform >= ends * steps : uniform < begins * steps;
            burstTick = tick;
        }
        return inBurst;
    }

    /**
     * Returns how much more probable a change of a two-state Markov chain is after several steps than after one, given
     * the sum of the probabilities of both changes: the sum of the powers (1 - both)^k for k from 0 to steps - 1.
     */
    private static double severalSteps(double both, long steps) {
        return steps == 1 ? 1 : (1 - StrictMath.pow(1 - both, steps)) / both;
    }
}
