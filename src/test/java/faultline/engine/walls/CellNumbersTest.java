package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CellNumbersTest {

    private final CellNumbers table = new CellNumbers();

    @Test
    void aCellHasNoNumberUntilItIsGivenOne() {
        assertTrue(table.isEmpty());
        assertFalse(table.contains(0));
        assertEquals(CellNumbers.NONE, table.get(0));
        table.put(0, 7);
        assertFalse(table.isEmpty());
        assertTrue(table.contains(0));
        assertEquals(7, table.get(0));
        assertEquals(CellNumbers.NONE, table.get(1));
    }

    @Test
    void aNewNumberReplacesTheOldOne() {
        table.put(Long.MIN_VALUE, 1);
        table.put(Long.MIN_VALUE, 0);
        assertEquals(0, table.get(Long.MIN_VALUE));
    }

    @Test
    void aClearedTableIsEmptyAndCanBeFilledAgain() {
        for (int i = 0; i < 1000; i++) {
            table.put(i, i);
        }
        table.clear();
        assertTrue(table.isEmpty());
        for (int i = 0; i < 1000; i++) {
            assertFalse(table.contains(i));
        }
        table.put(5, 2);
        assertEquals(2, table.get(5));
    }

    /** Strides of powers of two give keys whose low or high bits are all equal, so that many share a slot. */
    @ParameterizedTest
    @ValueSource(longs = {1, 64, 1L << 20, 1L << 32, 1L << 52, 0x9E3779B97F4A7C15L})
    void regularKeysAreKeptApart(long stride) {
        for (int i = -2000; i < 2000; i++) {
            table.put(i * stride, i + 2000);
        }
        for (int i = -2000; i < 2000; i++) {
            assertEquals(i + 2000, table.get(i * stride));
        }
        assertFalse(table.contains(2000 * stride));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void answersAsAMapOfBoxedKeysDoes(int seed) {
        Random random = new Random(seed);
        Map<Long, Integer> map = new HashMap<>();
        for (int i = 0; i < 20_000; i++) {
            long key = CellKey.of(random.nextInt(120) - 60, random.nextInt(120) - 60);
            assertEquals(map.getOrDefault(key, CellNumbers.NONE), table.get(key));
            assertEquals(map.containsKey(key), table.contains(key));
            if (random.nextInt(5000) == 0) {
                map.clear();
                table.clear();
            } else if (random.nextBoolean()) {
                int value = random.nextInt(100);
                map.put(key, value);
                table.put(key, value);
            }
            assertEquals(map.isEmpty(), table.isEmpty());
        }
    }

    @Test
    void noTwoCellsHaveTheSameKey() {
        Set<Long> keys = new HashSet<>();
        int[] indices = IntStream.concat(
                        IntStream.rangeClosed(-150, 150), IntStream.of(Integer.MIN_VALUE, Integer.MAX_VALUE))
                .toArray();
        for (int column : indices) {
            for (int row : indices) {
                assertTrue(keys.add(CellKey.of(column, row)), column + ", " + row);
            }
        }
    }
}
