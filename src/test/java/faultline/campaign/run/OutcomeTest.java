package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.HeadlessRun;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Outcomes of runs in an empty room, in which the time for the wall is over after two minutes. */
class OutcomeTest {

    private static final SimulationSetup ROOM =
            SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0));

    /** Wheels turn at 0.1 m/s per volt. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 1, UNDECIDED",
        "1, -1, 1, UNDECIDED",
        "3, 3, 10, COLLIDED",
        "0, 0, 150, STOPPED",
        "0.005, 0.005, 150, STOPPED",
        "-0.005, 0.005, 150, STOPPED",
        "1, 0, 150, LOST",
        "0, 1, 150, LOST",
        "-1, 0, 150, LOST",
        "0, -1, 150, LOST",
        "0.012, 0.012, 150, LOST"
    })
    void aRobotThatIsNotAtRestIsLost(double leftVolts, double rightVolts, double seconds, Outcome expected) {
        Decision decision = new Decision(leftVolts, rightVolts, Telemetry.ofState(FollowerState.SEARCH));
        SimulationSetup setup = ROOM.withDuration(seconds);
        CarryOnMetrics metrics = new CarryOnMetrics(setup, CarryOnMetrics.circuit(setup));
        Controller controller = observation -> decision;
        assertEquals(
                expected,
                Outcome.of(HeadlessRun.run(setup, controller, ControllerMode.DIRECT, List.of(metrics)), metrics));
    }

    @Test
    void aRunThatPassedTheWallCarriedOnEvenIfItEndsBeforeTheTimeLimit() {
        SimulationSetup setup = ROOM.withDuration(60);
        CarryOnMetrics metrics = new CarryOnMetrics(setup, CarryOnMetrics.circuit(setup));
        assertEquals(
                Outcome.CARRIED_ON,
                Outcome.of(HeadlessRun.run(setup, ControllerMode.DIRECT, List.of(metrics)), metrics));
    }

    @Test
    void everyOutcomeHasAWordAndABrokenRunHasNone() {
        assertEquals("carried_on", Outcome.CARRIED_ON.word());
        for (Outcome outcome : Outcome.values()) {
            assertEquals(Optional.of(outcome), Outcome.ofWord(outcome.word()));
        }
        assertEquals(Optional.empty(), Outcome.ofWord(Outcome.BROKEN));
        assertEquals(Optional.empty(), Outcome.ofWord("LOST"));
    }
}
