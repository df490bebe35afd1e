package faultline.world;

import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import faultline.sensor.SensorRandom;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;

/** One sensor on the robot with its faults. Confined to the world's thread. */
final class MountedSensor {

    private final long streamKey;
    private final List<Fault> faults = new ArrayList<>();
    private final ActiveFaults active = new ActiveFaults();
    private SensorSpec spec;
    private boolean outsideBody;
    private SensorCone soundCone;
    private SensorCone actualCone;

    MountedSensor(SensorSpec spec, long seed) {
        this.streamKey = SensorRandom.streamKey(seed, spec.id());
        this.spec = spec;
    }

    /** Applies changed settings; see {@link SensorCone#SensorCone} for the limits. */
    void configure(SensorSpec newSpec, RobotSpec robot, double maxTravel, double maxTurn) {
        spec = newSpec;
        outsideBody = Math.abs(spec.mountPosition().x()) > robot.length() / 2
                || Math.abs(spec.mountPosition().y()) > robot.width() / 2;
        soundCone = new SensorCone(spec, Obstacle.MATT, maxTravel, maxTurn);
        configureActualCone(maxTravel, maxTurn);
    }

    private void configureActualCone(double maxTravel, double maxTurn) {
        actualCone = active.changesOptics()
                ? new SensorCone(active.optics(spec), active.specularAngle(), maxTravel, maxTurn)
                : soundCone;
    }

    /** Lets added faults set in and removed ones end; returns whether the optics may have changed. */
    boolean updateFaults(long tick, double dt, double lastReported, double maxTravel, double maxTurn) {
        if (faults.isEmpty() && active.isEmpty()) {
            return false;
        }
        boolean before = active.changesOptics();
        boolean changed = active.update(faults, tick, dt, lastReported);
        if (changed && (before || active.changesOptics())) {
            configureActualCone(maxTravel, maxTurn);
            return true;
        }
        return false;
    }

    SensorSpec spec() {
        return spec;
    }

    List<Fault> faults() {
        return faults;
    }

    boolean isOutsideBody() {
        return outsideBody;
    }

    /** Returns the cone without faults. */
    SensorCone soundCone() {
        return soundCone;
    }

    /** Returns the cone with the faults of the optics; the same object if there are none. */
    SensorCone actualCone() {
        return actualCone;
    }

    /**
     * Returns the reported reading: noise is added, then the faults act.
     *
     * @param seen the reading of the actual cone
     * @param neighbour the true reading of the next sensor
     * @param tick the tick
     */
    double report(double seen, double neighbour, long tick) {
        if (!spec.on()) {
            return Reading.OFF;
        }
        if (spec.noise() == 0 && faults.isEmpty()) {
            return seen;
        }
        SensorRandom random = SensorRandom.forTick(streamKey, tick);
        return active.apply(addNoise(seen, random), tick, spec.range(), neighbour, random);
    }

    /** Adds noise to a distance, limited below by 0; beyond the range nothing is sensed. Nothing has no noise. */
    private double addNoise(double seen, SensorRandom random) {
        double noise = spec.noise() * random.nextGaussian();
        double reading = Math.max(0, seen + noise);
        return reading <= spec.range() ? reading : Reading.NOTHING;
    }
}
