package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.FollowerState;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ExpectationTest {

    private static final Collision COLLISION =
            new Collision(new Vector2(3, 1.5), 12.25, 1225, "desk", Map.of(), List.of(), MotorFaults.NONE);

    private static RunResult result(List<Collision> collisions, double coverage, double rms) {
        Snapshot last = new Snapshot(
                0,
                0,
                6,
                4,
                true,
                RobotSpec.DEFAULT,
                Pose.ORIGIN,
                new WheelSpeeds(0, 0),
                MotorFaults.NONE,
                List.of(),
                List.of(),
                List.of(),
                collisions);
        return new RunResult(
                100,
                1,
                50,
                FollowerState.FOLLOW,
                List.of(FollowerState.SEARCH, FollowerState.FOLLOW),
                coverage,
                false,
                rms,
                rms,
                1,
                1,
                List.of(),
                "",
                List.of(),
                last);
    }

    private static Expectation expectation(boolean collision, Expectation.Condition... states) {
        List<Expectation.Condition> conditions = new ArrayList<>(List.of(
                new Expectation.Collides(collision),
                new Expectation.MinCoverage(0.9),
                new Expectation.MaxDistanceRms(0.005)));
        conditions.addAll(List.of(states));
        return new Expectation(conditions);
    }

    private static Expectation.Condition visits(FollowerState state) {
        return new Expectation.VisitedState(state);
    }

    private static Expectation.Condition endsIn(FollowerState state) {
        return new Expectation.FinalState(state);
    }

    @Test
    void metExpectationsAreNotReported() {
        Expectation all = expectation(
                false, visits(FollowerState.FOLLOW), visits(FollowerState.SEARCH), endsIn(FollowerState.FOLLOW));
        assertEquals(List.of(), all.unmet(result(List.of(), 0.9, 0.005)));
        assertEquals(List.of(), Expectation.NONE.unmet(result(List.of(COLLISION), Double.NaN, Double.NaN)));
    }

    @Test
    void eachUnmetExpectationIsOneSentence() {
        Expectation all = expectation(
                false, visits(FollowerState.FOLLOW), visits(FollowerState.ROUND), endsIn(FollowerState.SEARCH));
        assertEquals(
                List.of(
                        "expected no collision, but the robot struck desk at 3,1.5 after 12.25 s",
                        "expected a coverage of at least 0.9, but it is 0.5",
                        "expected a distance error of at most 0.005 m RMS, but it is 0.01",
                        "expected the state ROUND, but it was never reached; passed: SEARCH FOLLOW",
                        "expected the final state SEARCH, but it is FOLLOW"),
                all.unmet(result(List.of(COLLISION), 0.5, 0.01)));
    }

    @Test
    void aSentenceHasReadableNumbersThatAreNeverWithinTheLimit() {
        Expectation.Condition coverage = new Expectation.MinCoverage(0.97);
        Expectation.Condition distance = new Expectation.MaxDistanceRms(0.005);
        Expectation all = new Expectation(List.of(new Expectation.Collides(false), coverage, distance));
        Collision collision = new Collision(
                new Vector2(4.2, 5.661382960239527),
                60.449199503620775,
                6045,
                "desk",
                Map.of(),
                List.of(),
                MotorFaults.NONE);
        assertEquals(
                List.of(
                        "expected no collision, but the robot struck desk at 4.2,5.661 after 60.449 s",
                        "expected a coverage of at least 0.97, but it is 0.6056",
                        "expected a distance error of at most 0.005 m RMS, but it is 0.012346"),
                all.unmet(result(List.of(collision), 0.6056250000000011, 0.0123456789)));
        assertEquals(
                List.of(
                        "expected a coverage of at least 0.97, but it is 0.9699999",
                        "expected a distance error of at most 0.005 m RMS, but it is 0.0050000001"),
                all.unmet(result(List.of(), 0.9699999, 0.0050000001)));
    }

    @Test
    void whatCouldNotBeMeasuredIsUnmet() {
        Expectation all = expectation(true, endsIn(FollowerState.FOLLOW));
        assertEquals(
                List.of(
                        "expected a collision, but there was none",
                        "expected a coverage of at least 0.9, but no wall was followed",
                        "expected a distance error of at most 0.005 m RMS, but no straight wall was followed"),
                all.unmet(result(List.of(), Double.NaN, Double.NaN)));
    }
}
