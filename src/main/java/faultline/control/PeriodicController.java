package faultline.control;

/** Lets a controller decide once a period; between its decisions the last one holds. Closes it if it can be closed. */
public final class PeriodicController implements Controller, AutoCloseable {

    private final Controller delegate;
    private final double period;
    private Decision lastDecision;

    /**
     * Creates a controller that asks another at a period, rounded to whole ticks, at least one.
     *
     * @param inner the other controller
     * @param period the period, in seconds, not negative
     */
    public PeriodicController(Controller inner, double period) {
        this.delegate = inner;
        this.period = period;
    }

    @Override
    public Decision decide(Observation observation) {
        long every = ticksPerPeriod(period, observation.dt());
        if (lastDecision == null || observation.tick() % every == 0) {
            lastDecision = delegate.decide(observation);
        }
        return lastDecision;
    }

    @Override
    public void close() {
        if (delegate instanceof AutoCloseable closeable) {
            try {
                closeable.close();
            } catch (Exception e) {
                throw new IllegalStateException("the controller cannot be closed: " + e, e);
            }
        }
    }

    @Override
    public void configure(ControllerSpec.BuiltIn settings) {
        delegate.configure(settings);
    }

    /**
     * {@return a period in whole ticks, at least one}
     *
     * @param period the period, in seconds, not negative
     * @param dt the length of a tick, in seconds, positive
     */
    public static long ticksPerPeriod(double period, double dt) {
        return Math.max(1, Math.round(period / dt));
    }
}
