package faultline.engine;

/**
 * A 64-bit hash over the raw bits of a run's numbers in order. Equal runs have equal hashes, and a single different bit
 * changes the hash.
 */
final class TrajectoryHash {

    private static final long MULTIPLIER = 0x9E3779B97F4A7C15L;

    private long hash = 0xCBF29CE484222325L;

    void add(double value) {
        long mixed = (hash ^ Double.doubleToLongBits(value)) * MULTIPLIER;
        hash = mixed ^ (mixed >>> 29);
    }

    long value() {
        return hash;
    }
}
