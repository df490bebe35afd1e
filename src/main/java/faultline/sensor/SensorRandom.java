package faultline.sensor;

/**
 * The random numbers of one sensor in one tick. They depend only on (seed, sensor id, tick), by SplitMix64 (Steele, Lea
 * and Flood 2014), and not on the number of earlier draws: switching a sensor, stepping back or replaying does not
 * change the noise of any sensor.
 */
public final class SensorRandom {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    private SensorRandom(long state) {
        this.state = state;
    }

    /**
     * {@return the key of a sensor's random numbers, for {@link #forTick}, from the run's seed and the sensor's id}
     *
     * @param seed the seed of the run
     * @param sensorId the id of the sensor
     */
    public static long streamKey(long seed, String sensorId) {
        long hash = mix(seed + GAMMA);
        for (int i = 0; i < sensorId.length(); i++) {
            hash = mix(hash + GAMMA + sensorId.charAt(i));
        }
        return hash;
    }

    /**
     * {@return the random numbers of one tick, the same for the same key and tick}
     *
     * @param streamKey the result of {@link #streamKey}
     * @param tick the tick
     */
    public static SensorRandom forTick(long streamKey, long tick) {
        return new SensorRandom(mix(streamKey ^ mix(tick * GAMMA + 1)));
    }

    /** {@return the next uniform number in [0, 1), a multiple of 2^-53} */
    public double nextDouble() {
        state += GAMMA;
        return (mix(state) >>> 11) * 0x1.0p-53;
    }

    /** {@return the next standard normal number, always finite, by the Box-Muller formula} */
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
