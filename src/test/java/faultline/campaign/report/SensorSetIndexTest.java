package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SensorSetIndexTest {

    private final SensorSetIndex index = new SensorSetIndex();

    private static BitSet set(int... sensors) {
        BitSet set = new BitSet();
        for (int sensor : sensors) {
            set.set(sensor);
        }
        return set;
    }

    @Test
    void aSetContainsItselfAndItsSubsets() {
        index.add(set(3, 70));
        assertTrue(index.hasSubset(set(3, 70)));
        assertTrue(index.hasSubset(set(1, 3, 70)));
        assertFalse(index.hasSubset(set(3)));
        assertFalse(index.hasSubset(set(70)));
        assertFalse(index.hasSubset(set()));
    }

    @Test
    void everySetContainsTheSetOfNoSensors() {
        assertFalse(index.hasSubset(set()));
        index.add(set());
        assertTrue(index.hasSubset(set()));
        assertTrue(index.hasSubset(set(2)));
    }

    @Test
    void theIndexAgreesWithAComparisonOfAllSets() {
        Random random = new Random(1);
        List<BitSet> added = new ArrayList<>();
        int found = 0;
        for (int i = 0; i < 2000; i++) {
            BitSet set = BitSet.valueOf(new long[] {random.nextInt(1 << 14) & random.nextInt(1 << 14)});
            boolean expected = added.stream().anyMatch(each -> {
                BitSet others = (BitSet) each.clone();
                others.andNot(set);
                return others.isEmpty();
            });
            assertEquals(expected, index.hasSubset(set), () -> set + " in " + added);
            found += expected ? 1 : 0;
            if (set.cardinality() > 2) {
                index.add(set);
                added.add(set);
            }
        }
        assertTrue(found > 100 && found < 1900, "both answers occur: " + found);
    }
}
