package faultline.campaign.report;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Sets of sensors, each under one of its sensors, so that a search for subsets compares few of them. */
final class SensorSetIndex {

    /** Instead of a sensor, for the set of none. */
    private static final int NO_SENSOR = -1;

    private final Map<Integer, List<BitSet>> sets = new HashMap<>();

    /** Adds a set of numbers of sensors, under the one that has the fewest sets so far. */
    void add(BitSet sensors) {
        int fewest = NO_SENSOR;
        for (int sensor = sensors.nextSetBit(0); sensor >= 0; sensor = sensors.nextSetBit(sensor + 1)) {
            if (fewest == NO_SENSOR || under(sensor).size() < under(fewest).size()) {
                fewest = sensor;
            }
        }
        sets.computeIfAbsent(fewest, first -> new ArrayList<>()).add(sensors);
    }

    /** Returns whether a set contains all sensors of one that was added. */
    boolean hasSubset(BitSet sensors) {
        return IntStream.concat(IntStream.of(NO_SENSOR), sensors.stream())
                .anyMatch(sensor -> under(sensor).stream().anyMatch(set -> contains(sensors, set)));
    }

    private List<BitSet> under(int sensor) {
        return sets.getOrDefault(sensor, List.of());
    }

    private static boolean contains(BitSet sensors, BitSet subset) {
        for (int sensor = subset.nextSetBit(0); sensor >= 0; sensor = subset.nextSetBit(sensor + 1)) {
            if (!sensors.get(sensor)) {
                return false;
            }
        }
        return true;
    }
}
