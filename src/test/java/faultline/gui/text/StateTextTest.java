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

    @Test
    void aControllersOwnReasonIsShownForATransitionOfTheBuiltInFollower() {
        assertEquals(
                "Follow → Turn: my reason",
                StateText.transition(FollowerState.FOLLOW, FollowerState.TURN, "my reason"));
        assertEquals("Follow → Turn", StateText.transition(FollowerState.FOLLOW, FollowerState.TURN, ""));
    }

    @Test
    void theConditionOfAnotherTransitionIsAReasonOfAController() {
        assertEquals(
                "Turn → Measure: wall ahead",
                StateText.transition(FollowerState.TURN, FollowerState.MEASURE, "wall ahead"));
    }

    @Test
    void theBuiltInFollowersConditionsAreInPlainWords() {
        assertEquals(
                "Turn → Measure: side sensor comes to the wall",
                StateText.transition(FollowerState.TURN, FollowerState.MEASURE, "left sensor comes to the wall (F3)"));
    }
}
