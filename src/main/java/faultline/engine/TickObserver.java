package faultline.engine;

/** Something that looks at a run after every tick, and at tick 0, on the run's own thread; it must change nothing. */
@FunctionalInterface
public interface TickObserver {

    /**
     * Called at tick 0 and after every tick.
     *
     * @param simulation the run
     */
    void observe(Simulation simulation);
}
