package faultline.control;

import java.util.ArrayList;
import java.util.List;

/** Records the decisions of a controller that is not part of the program. */
public final class DecisionLog {

    private final List<RecordedDecision> decisions = new ArrayList<>();

    /** Creates an empty log. */
    public DecisionLog() {}

    /**
     * Adds a decision unless it equals the last one.
     *
     * @param tick the tick of the observation that was decided on
     * @param decision the decision
     */
    public void add(long tick, Decision decision) {
        if (decisions.isEmpty() || decisions.get(decisions.size() - 1).differs(decision)) {
            decisions.add(new RecordedDecision(
                    tick,
                    decision.leftVolts(),
                    decision.rightVolts(),
                    decision.telemetry().state().name(),
                    decision.telemetry().condition()));
        }
    }

    /** {@return the decisions so far} */
    public List<RecordedDecision> decisions() {
        return List.copyOf(decisions);
    }
}
