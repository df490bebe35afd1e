package faultline.control;

/** Counts the transitions of a controller that only names its states. */
public final class StateTracker implements Controller {

    private final Controller delegate;
    private Telemetry last;

    /**
     * Tracks a controller.
     *
     * @param delegate the controller
     */
    public StateTracker(Controller delegate) {
        this.delegate = delegate;
    }

    @Override
    public Decision decide(Observation observation) {
        Decision decision = delegate.decide(observation);
        Telemetry given = decision.telemetry();
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
            return decision;
        }
        return new Decision(decision.leftVolts(), decision.rightVolts(), last);
    }
}
