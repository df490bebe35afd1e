package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.control.Threshold;
import faultline.control.TimingRule;
import faultline.robot.Velocity;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpinStatesTest {

    private final StateEstimate estimate = Observations.stateEstimate(0.25);
    private final SpinStates spin = new SpinStates(
            estimate, new AlignmentManoeuvre(estimate, TimingRule.EQUAL_READINGS, SpinClock.TURNED_ANGLE));

    @ParameterizedTest
    @EnumSource(
            value = FollowerState.class,
            names = {"SEARCH", "FOLLOW", "ROUND"})
    void onlyASpinBesideAWallCanFindTheSameWall(FollowerState from) {
        spin.turn().enter(from);
        assertEquals(from != FollowerState.SEARCH, spin.foundSameWall());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void aWallInAnotherDirectionIsAnotherWall(int side) {
        spin.turn().enter(FollowerState.FOLLOW);
        double angle = estimate.thresholds().radians(Threshold.SAME_WALL_ANGLE);
        turn(side, 0.9 * angle);
        assertTrue(spin.foundSameWall());
        turn(side, 0.2 * angle);
        assertFalse(spin.foundSameWall());
    }

    private void turn(int side, double angle) {
        for (double turned = 0; turned < angle; turned += Observations.DT) {
            Observations.drive(estimate, new Velocity(0, side));
        }
    }
}
