package faultline.world;

import faultline.sensor.Fault;
import faultline.sensor.FaultContext;
import faultline.sensor.Reading;
import faultline.sensor.SensorRandom;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** The active faults of one sensor with their contexts; mutable, on the world's thread. */
final class ActiveFaults {

    private record Active(Fault fault, FaultContext context) {}

    private List<Active> active = new ArrayList<>();

    /** Replaces the faults; those that continue keep their state. Returns whether any changed. */
    boolean update(List<Fault> faults, long tick, double dt, double lastReported) {
        if (isCurrent(faults)) {
            return false;
        }
        List<Active> before = new ArrayList<>(active);
        List<Active> now = new ArrayList<>();
        for (Fault fault : faults) {
            now.add(take(before, fault, new FaultContext(tick, dt, lastReported)));
        }
        active = now;
        return true;
    }

    private boolean isCurrent(List<Fault> faults) {
        boolean current = faults.size() == active.size();
        for (int i = 0; i < faults.size() && current; i++) {
            current = active.get(i).fault().equals(faults.get(i));
        }
        return current;
    }

    private static Active take(List<Active> before, Fault fault, FaultContext fresh) {
        for (Active old : before) {
            if (old.fault().equals(fault)) {
                before.remove(old);
                return old;
            }
        }
        return new Active(fault, fresh);
    }

    /** Applies all faults in their order, up to the first that silences the sensor. */
    double apply(double reading, long tick, double range, double neighbour, SensorRandom random) {
        double result = reading;
        for (Active each : active) {
            if (Reading.isOff(result)) {
                break;
            }
            result = each.fault().apply(result, each.context().at(tick, range, neighbour, random));
        }
        return result;
    }

    boolean isEmpty() {
        return active.isEmpty();
    }

    boolean changesOptics() {
        for (Active each : active) {
            if (each.fault().kind().changesOptics()) {
                return true;
            }
        }
        return false;
    }

    SensorSpec optics(SensorSpec spec) {
        SensorSpec changed = spec;
        for (Active each : active) {
            changed = each.fault().optics(changed);
        }
        return changed;
    }

    double specularAngle() {
        double angle = StrictMath.PI / 2;
        for (Active each : active) {
            angle = Math.min(angle, each.fault().specularAngle());
        }
        return angle;
    }
}
