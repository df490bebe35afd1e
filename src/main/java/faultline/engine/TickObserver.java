package faultline.engine;

/**
 * Observes a run at tick 0 and after every tick, on the run's own thread. It must not change what happens in the run;
 * it may end the recording of the path by {@link Simulation#stopRecordingPath}, and that of the decisions by
 * {@link Simulation#stopRecordingDecisions}.
 */
@FunctionalInterface
public interface TickObserver {

    /**
     * Called at tick 0 and after every tick.
     *
     * @param simulation the run
     */
    void observe(Simulation simulation);
}
