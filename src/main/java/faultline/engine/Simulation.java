package faultline.engine;

import faultline.geometry.Pose;
import faultline.world.Snapshot;

/** One run, tick by tick; belongs to one thread and holds no clock. */
public final class Simulation implements AutoCloseable {

    /**
     * A run at tick 0.
     *
     * @param setup what to run
     * @param mode where the controller runs
     */
    public Simulation(Setup setup, ControllerMode mode) {
    }

    /** Makes one tick. */
    public void tick() {
        throw new UnsupportedOperationException();
    }

    /**
     * How many ticks have passed.
     *
     * @return from 0
     */
    public long ticks() {
        throw new UnsupportedOperationException();
    }

    /**
     * The robot's pose.
     *
     * @return now
     */
    public Pose pose() {
        throw new UnsupportedOperationException();
    }

    /**
     * The world now.
     *
     * @return an immutable value
     */
    public Snapshot snapshot() {
        throw new UnsupportedOperationException();
    }

    @Override
    public void close() {
    }
}
