package faultline.world;

import faultline.sensor.Fault;
import faultline.sensor.FaultContext;
import faultline.sensor.FaultSequence;
import faultline.sensor.OldestFirst;
import faultline.sensor.Reading;
import faultline.sensor.SensorRandom;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The signal of one sensor: its readings with noise and faults. Confined to the simulation thread. */
final class SensorSignal {

    private record ActiveFault(Fault fault, FaultContext context) {}

    private final long streamKey;
    private FaultSequence<Fault> faults = FaultSequence.empty();
    private List<ActiveFault> active = new ArrayList<>();
    private SensorSpec spec;
    /** Whether it reports what it sees unless it has faults. */
    private boolean exact;

    SensorSignal(SensorSpec spec, long seed) {
        streamKey = SensorRandom.streamKey(seed, spec.id());
        configure(spec);
    }

    private SensorSignal(SensorSignal other) {
        streamKey = other.streamKey;
        faults = other.faults;
        other.active.forEach(
                each -> active.add(new ActiveFault(each.fault(), each.context().copy())));
        configure(other.spec);
    }

    /** Returns a copy in the same state. */
    SensorSignal copy() {
        return new SensorSignal(this);
    }

    /** Applies changed settings. */
    void configure(SensorSpec newSpec) {
        spec = newSpec;
        exact = newSpec.on() && newSpec.noise() == 0;
    }

    /** Returns the sensor's faults, oldest first. */
    FaultSequence<Fault> faults() {
        return faults;
    }

    /** Sets the sensor's faults, oldest first, which take effect at the next {@link #update}. */
    void setFaults(FaultSequence<Fault> newFaults) {
        faults = newFaults;
    }

    /** Returns whether the sensor reports what it sees and no fault begins or ends at the next {@link #update}. */
    boolean isExact() {
        return exact && faults.isEmpty() && active.isEmpty();
    }

    /**
     * Starts the added faults and ends the removed ones; the others keep their state. Of equal faults, the oldest end
     * first. Returns whether the optics may have changed.
     */
    boolean update(long tick, double dt, double lastReported) {
        int same = countLeadingActive();
        if (same == active.size() && same == faults.size()) {
            return false;
        }
        boolean before = changesOptics();
        Map<Fault, Integer> ending = countEnding(same);
        int kept = isOneOf(ending, active.subList(0, same)) ? 0 : same;
        OldestFirst<Fault, ActiveFault> continuing = continuing(active.subList(kept, active.size()), ending);
        List<ActiveFault> now = new ArrayList<>(active.subList(0, kept));
        for (Fault fault : faults.subList(kept, faults.size())) {
            now.add(continuing
                    .end(fault)
                    .orElseGet(() -> new ActiveFault(fault, new FaultContext(tick, dt, lastReported))));
        }
        active = now;
        return before || changesOptics();
    }

    /** Returns how many of each fault end, of those that end, given how many faults at the start are the same. */
    private Map<Fault, Integer> countEnding(int same) {
        Map<Fault, Integer> ending = new HashMap<>();
        active.subList(same, active.size()).forEach(each -> ending.merge(each.fault(), 1, Integer::sum));
        faults.subList(same, faults.size()).forEach(fault -> ending.merge(fault, -1, Integer::sum));
        ending.values().removeIf(count -> count <= 0);
        return ending;
    }

    private static boolean isOneOf(Map<Fault, Integer> ending, List<ActiveFault> some) {
        return !ending.isEmpty() && some.stream().anyMatch(each -> ending.containsKey(each.fault()));
    }

    /** Returns the faults that do not end. */
    private static OldestFirst<Fault, ActiveFault> continuing(List<ActiveFault> some, Map<Fault, Integer> ending) {
        OldestFirst<Fault, ActiveFault> continuing = new OldestFirst<>();
        some.forEach(each -> continuing.begin(each.fault(), each));
        ending.forEach((fault, count) -> {
            for (int i = 0; i < count; i++) {
                continuing.end(fault);
            }
        });
        return continuing;
    }

    /** Returns how many faults at the start of the list are active in the same place. */
    private int countLeadingActive() {
        int most = Math.min(faults.size(), active.size());
        int count = 0;
        while (count < most && active.get(count).fault().equals(faults.get(count))) {
            count++;
        }
        return count;
    }

    /** Returns whether a fault changes what the sensor sees, and not only what it reports. */
    boolean changesOptics() {
        for (ActiveFault each : active) {
            if (each.fault().kind().changesOptics()) {
                return true;
            }
        }
        return false;
    }

    /** Returns the sensor as its faults change it. */
    SensorSpec faultySpec() {
        SensorSpec changed = spec;
        for (ActiveFault each : active) {
            changed = each.fault().optics(changed);
        }
        return changed;
    }

    /** Returns the greatest angle of incidence at which any flat surface is sensed, radians. */
    double specularAngle() {
        double angle = StrictMath.PI / 2;
        for (ActiveFault each : active) {
            angle = Math.min(angle, each.fault().specularAngle());
        }
        return angle;
    }

    /**
     * Returns the reported reading: noise is added, then the faults act in their order, up to the first that silences
     * the sensor.
     *
     * @param seen the reading of the cone with its faults
     * @param neighbour the true reading of the next sensor
     * @param tick the tick
     */
    double report(double seen, double neighbour, long tick) {
        if (exact && faults.isEmpty()) {
            return seen;
        }
        if (!spec.on()) {
            return Reading.OFF;
        }
        SensorRandom random = SensorRandom.forTick(streamKey, tick);
        double result = addNoise(seen, random);
        for (ActiveFault each : active) {
            if (Reading.isOff(result)) {
                break;
            }
            result = each.fault().apply(result, each.context().at(tick, spec.range(), neighbour, random));
        }
        return result;
    }

    /**
     * Adds noise to a distance, limited below by 0; beyond the range nothing is sensed. A missing reading stays
     * missing.
     */
    private double addNoise(double seen, SensorRandom random) {
        double noise = spec.noise() * random.nextGaussian();
        return Reading.encode(seen + noise, spec.range());
    }
}
