package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.wallfollower.Observations;
import faultline.control.wallfollower.StraightWallFixture;
import faultline.robot.RobotSpec;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** What the wall follower shows of its working, beside a long wall. */
class TelemetryTest {

    private static StraightWallFixture start() {
        return new StraightWallFixture(RobotSpec.DEFAULT, WallFollowing.DEFAULT, 1.2, 90);
    }

    @Test
    void theFirstMeetingPassesAllOfTurnMeasureAndAlign() {
        StraightWallFixture robot = start().runUntil(FollowerState.FOLLOW);
        assertEquals(
                List.of(
                        FollowerState.SEARCH,
                        FollowerState.TURN,
                        FollowerState.MEASURE,
                        FollowerState.ALIGN,
                        FollowerState.FOLLOW),
                robot.states());
        assertEquals(4, robot.telemetry().transitions());
    }

    @Test
    void whileSearchingOnlyTheWantedDistanceIsANumber() {
        Telemetry telemetry = start().runUntil(FollowerState.SEARCH).telemetry();
        assertEquals("", telemetry.condition());
        assertEquals(0, telemetry.transitions());
        assertEquals(0.25, telemetry.wall().wantedDistance());
        assertEquals(Double.POSITIVE_INFINITY, telemetry.wall().measuredDistance());
        for (double none : new double[] {
            telemetry.wall().proportional(),
            telemetry.wall().derivative(),
            telemetry.edges().tF3(),
            telemetry.edges().tF4(),
            telemetry.edges().tP()
        }) {
            assertTrue(Double.isNaN(none));
        }
    }

    @Test
    void aTextOfAControllerFromOutsideIsCutOff() {
        assertEquals("FOLLOW", Telemetry.limited("FOLLOW"));
        assertEquals("x".repeat(200), Telemetry.limited("x".repeat(201)));
        Telemetry whole = Telemetry.ofState(ControllerState.of("x".repeat(200)));
        assertSame(whole, whole.limited());
        assertEquals(
                whole, Telemetry.ofState(ControllerState.of("x".repeat(201))).limited());
    }

    @Test
    void noPartIsNull() {
        Telemetry good = Telemetry.ofState(FollowerState.SEARCH);
        Stream.<Executable>of(
                        () -> Telemetry.ofState(null),
                        () -> new Telemetry(good.state(), null, 0, 0, good.wall(), good.edges(), good.diagnosis()),
                        () -> new Telemetry(good.state(), "", 0, 0, null, good.edges(), good.diagnosis()),
                        () -> new Telemetry(good.state(), "", 0, 0, good.wall(), null, good.diagnosis()),
                        () -> new Telemetry(good.state(), "", 0, 0, good.wall(), good.edges(), null),
                        () -> new Telemetry.Diagnosis(null, List.of()),
                        () -> SensorHealth.trusted(null),
                        () -> new SensorHealth("left", null, SensorFinding.NONE, 0, 0),
                        () -> new SensorHealth("left", SensorTrust.TRUSTED, null, 0, 0))
                .forEach(creation -> assertThrows(NullPointerException.class, creation));
    }

    @Test
    void theConditionAndTheTickOfTheLastTransitionAreShown() {
        Telemetry telemetry = start().runUntil(FollowerState.TURN).telemetry();
        assertEquals("wall met", telemetry.condition());
        long expected = Math.round((1.2 - 0.35) / 0.3 / Observations.DT);
        assertEquals(
                expected,
                telemetry.sinceTick(),
                10,
                "the way to 0.35 m from the wall takes 2.83 s, less the motors' lag");
    }

    @Test
    void theFramesShowOnceTheWallHasBeenLeft() {
        assertTrue(Double.isNaN(
                start().runUntil(FollowerState.MEASURE).telemetry().edges().tF4()));
        assertTrue(start().runUntil(FollowerState.ALIGN).telemetry().edges().tF4() > 0);
    }

    @Test
    void whileFollowingTheReadingAndBothTermsShow() {
        Telemetry telemetry = start().runUntil(FollowerState.FOLLOW).telemetry();
        assertEquals(0.25, telemetry.wall().measuredDistance(), 0.02);
        assertTrue(Double.isFinite(telemetry.wall().proportional())
                && Double.isFinite(telemetry.wall().derivative()));
    }
}
