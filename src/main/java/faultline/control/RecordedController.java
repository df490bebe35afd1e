package faultline.control;

/** Repeats the decisions of an earlier run, and ends the run with an error at the end of the record. */
public final class RecordedController implements Controller {

    private final ControllerSpec.Recorded record;
    private Telemetry telemetry;
    private Decision decision;
    private int next;

    /**
     * Creates a controller.
     *
     * @param record the decisions to repeat
     * @param initialState the state before the first decision
     */
    public RecordedController(ControllerSpec.Recorded record, ControllerState initialState) {
        this.record = record;
        telemetry = Telemetry.ofState(initialState);
        decision = new Decision(0, 0, telemetry);
    }

    @Override
    public Decision decide(Observation observation) {
        if (observation.tick() >= record.ticks()) {
            throw new RecordEndedException(record.ticks());
        }
        while (next < record.decisions().size() && record.decisions().get(next).tick() <= observation.tick()) {
            repeat(record.decisions().get(next++));
        }
        return decision;
    }

    private void repeat(RecordedDecision recorded) {
        if (!recorded.state().isEmpty()) {
            telemetry = telemetry.entering(recorded.state(), recorded.condition(), recorded.tick());
        }
        decision = new Decision(recorded.leftVolts(), recorded.rightVolts(), telemetry);
    }
}
