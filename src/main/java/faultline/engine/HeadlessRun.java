package faultline.engine;

import java.util.List;

/** Runs a setup to its end without a window. */
public final class HeadlessRun {

    private HeadlessRun() {
    }

    /**
     * Runs to the setup's duration, as fast as possible.
     *
     * @param setup what to run
     * @param mode where the controller runs
     * @param observers called after every tick, in order
     * @return what it came to
     * @throws RunFailedException if the run broke
     */
    public static RunResult run(Setup setup, ControllerMode mode, List<TickObserver> observers) {
        throw new UnsupportedOperationException();
    }
}
