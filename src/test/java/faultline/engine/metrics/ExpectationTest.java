package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class ExpectationTest {

    private static final Collision COLLISION =
            new Collision(new Vector2(3, 1.5), 12.25, 1225, "desk", Map.of(), List.of());

    private static RunResult result(Optional<Collision> collision, OptionalDouble coverage, OptionalDouble rms) {
        Snapshot last = new Snapshot(
                0,
                0,
                6,
                4,
                true,
                RobotSpec.DEFAULT,
                Pose.ORIGIN,
                WheelSpeeds.ZERO,
                List.of(),
                List.of(),
                List.of(),
                collision.stream().toList());
        return new RunResult(
                100,
                1,
                50,
                FollowerState.FOLLOW,
                List.of(FollowerState.SEARCH, FollowerState.FOLLOW),
                collision,
                coverage,
                rms,
                1,
                1,
                List.of(),
                "",
                List.of(),
                last);
    }

    private static Expectation expectation(
            Optional<Boolean> collision,
            OptionalDouble coverage,
            OptionalDouble rms,
            List<ControllerState> states,
            ControllerState last) {
        return new Expectation(collision, coverage, rms, states, Optional.of(last));
    }

    @Test
    void metExpectationsAreNotReported() {
        Expectation all = expectation(
                Optional.of(false),
                OptionalDouble.of(0.9),
                OptionalDouble.of(0.005),
                List.of(FollowerState.FOLLOW, FollowerState.SEARCH),
                FollowerState.FOLLOW);
        assertEquals(List.of(), all.unmet(result(Optional.empty(), OptionalDouble.of(0.9), OptionalDouble.of(0.005))));
        assertEquals(
                List.of(),
                Expectation.NONE.unmet(result(Optional.of(COLLISION), OptionalDouble.empty(), OptionalDouble.empty())));
    }

    @Test
    void eachUnmetExpectationIsOneSentence() {
        Expectation all = expectation(
                Optional.of(false),
                OptionalDouble.of(0.9),
                OptionalDouble.of(0.005),
                List.of(FollowerState.FOLLOW, FollowerState.ROUND),
                FollowerState.SEARCH);
        assertEquals(
                List.of(
                        "expected no collision, but the robot struck desk at 3,1.5 after 12.25 s",
                        "expected a coverage of at least 0.9, but it is 0.5",
                        "expected a distance error of at most 0.005 m RMS, but it is 0.01",
                        "expected the state ROUND, but it was never reached; passed: SEARCH FOLLOW",
                        "expected the final state SEARCH, but it is FOLLOW"),
                all.unmet(result(Optional.of(COLLISION), OptionalDouble.of(0.5), OptionalDouble.of(0.01))));
    }

    @Test
    void whatCouldNotBeMeasuredIsUnmet() {
        Expectation all = expectation(
                Optional.of(true), OptionalDouble.of(0.9), OptionalDouble.of(0.005), List.of(), FollowerState.FOLLOW);
        assertEquals(
                List.of(
                        "expected a collision, but there was none",
                        "expected a coverage of at least 0.9, but no wall was followed",
                        "expected a distance error of at most 0.005 m RMS, but no straight wall was followed"),
                all.unmet(result(Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty())));
    }
}
