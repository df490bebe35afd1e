package faultline.control;

/** Lets a controller decide once a period; between its decisions the last one holds. */
final class Periodic implements Controller {

    private final Controller inner;
    private final double period;
    private Decision held;

    /** A controller that asks another every {@code period} seconds, rounded to whole ticks, at least one. */
    Periodic(Controller inner, double period) {
        this.inner = inner;
        this.period = period;
    }

    @Override
    public Decision decide(Observation observation) {
        long every = ticks(period, observation.dt());
        if (held == null || observation.tick() % every == 0) {
            held = inner.decide(observation);
        }
        return held;
    }

    /** A period in whole ticks, at least one. */
    static long ticks(double period, double dt) {
        return Math.max(1, Math.round(period / dt));
    }
}
