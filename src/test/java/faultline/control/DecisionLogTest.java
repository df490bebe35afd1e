package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class DecisionLogTest {

    @Test
    void aDecisionThatHoldsIsRecordedOnceWhateverBlanksAreInItsTexts() {
        Telemetry telemetry = Telemetry.ofState(ControllerState.of("go  home")).entering("turn\tback", "wall\n met", 1);
        DecisionLog log = new DecisionLog();
        for (int tick = 1; tick < 5; tick++) {
            log.add(tick, new Decision(1, 2, telemetry));
        }
        assertEquals(List.of(new RecordedDecision(1, 1, 2, "turn back", "wall met")), log.decisions());
    }
}
