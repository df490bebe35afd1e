package faultline.engine.walls;

import java.util.Arrays;

/**
 * A number for each of some cells, which {@link CellKey} identifies. This class replaces a map with boxed keys, because
 * the coverage of one run looks up millions of cells.
 */
final class CellNumbers {

    /** The result of {@link #get} for a cell without a number. */
    static final int NONE = -1;

    private static final int MIN_CAPACITY = 64;

    /** The keys and the numbers of a hash table with linear probing. */
    private long[] keys = new long[MIN_CAPACITY];

    private int[] values = newValues(MIN_CAPACITY);
    private int size;

    private static int[] newValues(int capacity) {
        int[] values = new int[capacity];
        Arrays.fill(values, NONE);
        return values;
    }

    /** Returns the number of a cell, {@link #NONE} if it has none. */
    int get(long key) {
        return values[slot(key)];
    }

    boolean contains(long key) {
        return values[slot(key)] != NONE;
    }

    boolean isEmpty() {
        return size == 0;
    }

    /** Sets the number of a cell, not negative. */
    void put(long key, int value) {
        int slot = slot(key);
        if (values[slot] == NONE) {
            if (2 * size >= keys.length) {
                grow();
                slot = slot(key);
            }
            keys[slot] = key;
            size++;
        }
        values[slot] = value;
    }

    /** Removes all numbers. */
    void clear() {
        Arrays.fill(values, NONE);
        size = 0;
    }

    /** Returns the place of a key, or the free one that it would take. */
    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = (int) ((key * 0x9E3779B97F4A7C15L) >>> 32) & mask;
        while (values[slot] != NONE && keys[slot] != key) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldValues = values;
        keys = new long[2 * oldKeys.length];
        values = newValues(keys.length);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldValues[i] != NONE) {
                int slot = slot(oldKeys[i]);
                keys[slot] = oldKeys[i];
                values[slot] = oldValues[i];
            }
        }
    }
}
