package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.FollowerState;
import org.junit.jupiter.api.Test;

/** The sentences about transitions. */
class StateTextTest {

    @Test
    void aTransitionEndsWithItsConditionIfItHasOne() {
        assertEquals(
                "Follow → Measure: out of patience",
                StateText.transition(FollowerState.FOLLOW, FollowerState.MEASURE, "out of patience"));
        assertEquals("Measure → Follow", StateText.transition(FollowerState.MEASURE, FollowerState.FOLLOW, ""));
    }
}
