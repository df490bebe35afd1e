package faultline.campaign.plan;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Makes the draws of a plan. A number depends only on the plan's seed, the name of its stream and the block, so that
 * runs can be made in any order on any machine. All runs of a block have the same draws and can therefore be compared
 * in pairs.
 */
final class UniformSampler implements AttributeValue.UniformSource {

    private static final long GAMMA = 0x9E3779B97F4A7C15L;

    /**
     * The most blocks whose random order is kept as a table, of 4 bytes a block and stream. Draws of up to this number
     * of blocks are those of earlier versions.
     */
    static final int MAX_TABLE = 1_000_000;

    /** Four make a random order (Luby and Rackoff 1988); two more, because the halves of a number are short. */
    private static final int ROUNDS = 6;

    private final long seed;
    private final boolean latin;
    private final int blocks;
    private final Map<String, int[]> strata = new ConcurrentHashMap<>();

    /**
     * Creates a sampler.
     *
     * @param seed the seed of all draws
     * @param latin whether each stream is a Latin hypercube: its range is divided into {@code blocks} equal parts, and
     *     one value is drawn from each
     * @param blocks the number of blocks of the plan
     */
    UniformSampler(long seed, boolean latin, int blocks) {
        this.seed = seed;
        this.latin = latin;
        this.blocks = blocks;
    }

    @Override
    public double uniform(String stream, long block) {
        long key = key(stream);
        double plain = toUnit(mix(key ^ mix(block * GAMMA + 1)));
        if (!latin) {
            return plain;
        }
        int stratum = blocks <= MAX_TABLE
                ? strata.computeIfAbsent(stream, name -> permutation(key))[(int) block]
                : permuted(key, (int) block);
        return Math.min((stratum + plain) / blocks, Math.nextDown(1.0));
    }

    private long key(String stream) {
        long hash = mix(seed + GAMMA);
        for (int i = 0; i < stream.length(); i++) {
            hash = mix(hash + GAMMA + stream.charAt(i));
        }
        return hash;
    }

    /** Returns a random order of all strata, by Fisher and Yates. */
    private int[] permutation(long key) {
        int[] order = new int[blocks];
        long state = mix(key + 1);
        for (int i = 0; i < blocks; i++) {
            state += GAMMA;
            int j = (int) (toUnit(mix(state)) * (i + 1));
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    /**
     * Returns the stratum of a block in a random order that needs no table. A Feistel network permutes the numbers of
     * an even number of bits; it is repeated until the result is a stratum (Black and Rogaway 2002, "Ciphers with
     * Arbitrary Finite Domains").
     */
    private int permuted(long key, int block) {
        int halfBits = (33 - Integer.numberOfLeadingZeros(blocks - 1)) / 2;
        int mask = (1 << halfBits) - 1;
        int number = block;
        do {
            int left = number >>> halfBits;
            int right = number & mask;
            for (int round = 1; round <= ROUNDS; round++) {
                int mixed = left ^ (int) mix(mix(key + round) + right) & mask;
                left = right;
                right = mixed;
            }
            number = left << halfBits | right;
        } while (number >= blocks);
        return number;
    }

    private static double toUnit(long bits) {
        return (bits >>> 11) * 0x1.0p-53;
    }

    /** Computes the output function of SplitMix64 (Steele, Lea and Flood 2014), independently of the JDK. */
    private static long mix(long z) {
        long first = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        long second = (first ^ (first >>> 27)) * 0x94D049BB133111EBL;
        return second ^ (second >>> 31);
    }
}
