package faultline.control;

import java.util.Objects;

/**
 * Counts the state transitions of a controller that reports only the names of its states, and limits its texts. It is
 * closed with that controller.
 */
@SuppressWarnings("try") // The caller reports every exception, an interruption too.
public final class StateTracker implements Controller, AutoCloseable {

    private final Controller delegate;
    private final String name;
    private Telemetry last;

    /**
     * Tracks a controller.
     *
     * @param delegate the controller
     * @param name its name, on one line; empty if it has none
     */
    public StateTracker(Controller delegate, String name) {
        this.delegate = delegate;
        this.name = name;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Decision decide(Observation observation) {
        Decision decision = Objects.requireNonNull(delegate.decide(observation), "decide returned null");
        Telemetry given = decision.telemetry().limited();
        if (last == null) {
            last = given;
        } else if (given.transitions() == 0) {
            Telemetry entered = last.entering(given.state().name(), given.condition(), observation.tick());
            last = new Telemetry(
                    entered.state(),
                    entered.condition(),
                    entered.sinceTick(),
                    entered.transitions(),
                    given.wall(),
                    given.edges(),
                    given.diagnosis());
        } else {
            return new Decision(decision.leftVolts(), decision.rightVolts(), given);
        }
        return new Decision(decision.leftVolts(), decision.rightVolts(), last);
    }

    @Override
    public void close() throws Exception {
        if (delegate instanceof AutoCloseable closeable) {
            closeable.close();
        }
    }
}
