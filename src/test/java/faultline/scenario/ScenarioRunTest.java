package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.metrics.Expectation;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Reading;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** Tests the results of a run that a user's test can query. */
class ScenarioRunTest {

    private static ScenarioRun run(String name) throws ScenarioException {
        return Scenario.load(Path.of("scenarios", name)).run();
    }

    @Test
    void threeLinesLoadRunAndAssert() throws ScenarioException {
        ScenarioRun run =
                Scenario.load(Path.of("scenarios/inner-corner-90.xml")).run();
        assertEquals(List.of(), run.unmetExpectations());
        assertTrue(run.collision().isEmpty()
                && run.states().contains("FOLLOW")
                && run.coverage().orElse(0) > 0.9);
    }

    @Test
    void anExpectationThatTheRunDoesNotMeetIsNamed() throws ScenarioException {
        Scenario room = Scenario.load(Path.of("scenarios/collision-on-purpose.xml"));
        Expectation none = new Expectation(List.of(new Expectation.Collides(false)));
        List<String> unmet = room.withExpectation(none).run().unmetExpectations();
        assertEquals(1, unmet.size());
        assertTrue(unmet.get(0).contains("pole"), unmet.get(0));
    }

    @Test
    void thePoseAndTheStateAtATimeAreKept() throws ScenarioException {
        ScenarioRun run = run("collision-on-purpose.xml");
        assertEquals(1, run.poseAt(0).x());
        // 3 V times 0.1 m/s per volt, less the 50 ms that the motor takes to follow.
        assertEquals(1 + 0.3 * (5 - 0.05), run.poseAt(5).x(), 0.002);
        assertEquals("DRIVE", run.stateAt(5));
    }

    @Test
    void theReadingsAtATimeAreKeptAsTheyWereAndAsTheyWereReported() throws ScenarioException {
        ScenarioRun run = run("every-fault.xml");
        assertEquals(0.5, run.trueReading("front", 7).distance().orElseThrow(), 1e-12);
        assertEquals(OptionalDouble.of(0.2), run.reading("front", 7).distance());
        assertEquals(0.6, run.reading("front", 17).distance().orElseThrow(), 1e-12);
        assertTrue(run.reading("front", 37).isOff());
        assertEquals(0.4, run.reading("front", 50).distance().orElseThrow(), 1e-12);
        assertEquals(run.trueReading("front", 58), run.reading("front", 58));
        assertEquals(new Reading(Reading.NOTHING), run.reading("rear", 7));
    }

    @Test
    void theCollisionHasItsPointObstacleAndFaultySensors() throws ScenarioException {
        ScenarioRun run = run("collision-on-purpose.xml");
        assertEquals("pole", run.collision().orElseThrow().obstacle());
        assertEquals(
                List.of("front"),
                List.copyOf(run.collision().orElseThrow().faults().keySet()));
    }

    @Test
    void theHashIsTheSameForEveryRunAndWhereverTheControllerRuns() throws ScenarioException {
        Scenario scenario = Scenario.load(Path.of("scenarios/inner-corner-60.xml"));
        String hash = scenario.run().trajectoryHash();
        assertTrue(hash.matches("[0-9a-f]{16}"), hash);
        assertEquals(hash, scenario.run().trajectoryHash());
        assertEquals(
                hash, ScenarioRun.execute(scenario, ControllerMode.OWN_THREAD).trajectoryHash());
    }

    @Test
    void whatIsNotThereIsRefusedInOneSentence() throws ScenarioException {
        ScenarioRun run = run("struck-by-a-visitor.xml");
        assertEquals(
                "there is no 20.5 s in a run of 20.0 s",
                assertThrows(IllegalArgumentException.class, () -> run.poseAt(20.5))
                        .getMessage());
        assertThrows(IllegalArgumentException.class, () -> run.poseAt(-1));
        assertThrows(IllegalArgumentException.class, () -> run.poseAt(-0.0099));
        assertThrows(IllegalArgumentException.class, () -> run.poseAt(Double.NaN));
        assertEquals(
                "the robot has no sensor \"lefft\", only front, front-left, left, rear-left, "
                        + "rear, rear-right, right, front-right; did you mean "
                        + "\"left\"?",
                assertThrows(IllegalArgumentException.class, () -> run.reading("lefft", 1))
                        .getMessage());
    }
}
