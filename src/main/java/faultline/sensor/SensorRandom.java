package faultline.sensor;

/**
 * The random numbers of one sensor in one tick. They follow from (seed, sensor id, tick) alone, by SplitMix64 (Steele,
 * Lea and Flood 2014), so that no draw depends on how many others were made before it: switching a sensor, stepping
 * back or replaying changes nobody's noise.
 */
public final class SensorRandom {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    private SensorRandom(long state) {
        this.state = state;
    }

    /**
     * The stream of a sensor, to be asked for each tick's dice.
     *
     * @param seed the run's seed
     * @param sensorId the sensor
     * @return a number to give to {@link #forTick}
     */
    public static long streamKey(long seed, String sensorId) {
        long hash = mix(seed + GAMMA);
        for (int i = 0; i < sensorId.length(); i++) {
            hash = mix(hash + GAMMA + sensorId.charAt(i));
        }
        return hash;
    }

    /**
     * The dice of one tick.
     *
     * @param stream from {@link #streamKey}
     * @param tick the tick
     * @return fresh dice, the same for the same arguments
     */
    public static SensorRandom forTick(long stream, long tick) {
        return new SensorRandom(mix(stream ^ mix(tick * GAMMA + 1)));
    }

    /**
     * The next uniform number.
     *
     * @return in [0, 1), a multiple of 2^-53
     */
    public double nextDouble() {
        state += GAMMA;
        return (mix(state) >>> 11) * 0x1.0p-53;
    }

    /**
     * The next standard normal number, by the Box-Muller formula.
     *
     * @return finite; mean 0, standard deviation 1
     */
    public double nextGaussian() {
        double radius = StrictMath.sqrt(-2 * StrictMath.log(1 - nextDouble()));
        return radius * StrictMath.cos(2 * StrictMath.PI * nextDouble());
    }

    private static long mix(long z) {
        long first = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        long second = (first ^ (first >>> 27)) * 0x94D049BB133111EBL;
        return second ^ (second >>> 31);
    }
}
