package faultline.engine.walls;

import java.util.stream.IntStream;

/** Sets of the numbers from 0 on that are joined step by step (union-find with path halving). */
public final class DisjointSets {

    private final int[] parents;

    /**
     * Creates a set for each number.
     *
     * @param count how many numbers there are
     */
    public DisjointSets(int count) {
        parents = IntStream.range(0, count).toArray();
    }

    /**
     * Joins the sets of two numbers.
     *
     * @param one a number, at least 0 and less than the count
     * @param other a number, at least 0 and less than the count
     */
    public void join(int one, int other) {
        int a = least(one);
        int b = least(other);
        parents[Math.max(a, b)] = Math.min(a, b);
    }

    /**
     * {@return the least number in the set of a number}
     *
     * @param number a number, at least 0 and less than the count
     */
    public int least(int number) {
        int at = number;
        while (parents[at] != at) {
            parents[at] = parents[parents[at]];
            at = parents[at];
        }
        return at;
    }
}
