package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Thresholds that change in the middle of a run, in a room with slight, square and outer corners. */
class ThresholdChangesTest {

    private static final String ROOM =
            """
            <scenario xmlns="urn:faultline:scenario:1" name="Corners" duration="150" seed="41">
              <world width="5.3" height="4.1">
                <wall id="bent" x="0" y="0" points="0,3.3 2.4,3.6 5.3,3.2"/>
                <rectangle id="pillar" x="5" y="1.6" width="0.6" height="0.7"/>
              </world>
              <robot x="2.2" y="0.9" heading="13"/>
              <controller diagnosis="off" hand="right"/>
            </scenario>
            """;

    private static final long CHANGE = 900;

    @TempDir
    private Path folder;

    private Scenario scenario(String text) throws Exception {
        return Scenario.load(Files.writeString(folder.resolve("room.xml"), text));
    }

    private static String hash(Simulation simulation) {
        return String.format(Locale.ROOT, "%016x", simulation.trajectoryHash());
    }

    private static void advance(Simulation simulation, long tick) {
        while (simulation.ticks() < tick) {
            simulation.tick();
        }
    }

    private static Command.ConfigureController change(WallFollowing follower) {
        return new Command.ConfigureController(follower);
    }

    /** Runs a scenario with a change in it and returns the journal, from which it is replayed. */
    private static Journal runWith(Scenario scenario, Command change) {
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            advance(simulation, CHANGE);
            simulation.execute(change);
            advance(simulation, scenario.setup().ticks());
            return simulation.journal();
        }
    }

    private String replay(Scenario scenario, Journal journal) throws Exception {
        Path file = folder.resolve("journal.xml");
        JournalScenario.create(scenario, journal).save(file);
        return Scenario.load(file).run().trajectoryHash();
    }

    @ParameterizedTest
    @CsvSource({
        "AHEAD_MARGIN, 0.11, ''",
        "TURN_CLEARANCE, 0.4, ''",
        "TIMING_LEVEL, 0.25, ''",
        "SETTLED_RATE, 25, ''",
        "LOST_MARGIN, 0.001, ''",
        "BEND_SHARE, 0.95, ''",
        "GIVE_UP_ANGLE, 20, ''",
        "SAME_WALL_ANGLE, 120, steerThrough='3'",
        "STEER_THROUGH, 2.5, sameWallAngle='120'",
    })
    void aChangeFromOutsideAnElementOfTheTimelineAndTheJournalGiveOneRun(
            Threshold threshold, double value, String attributes) throws Exception {
        Scenario base = scenario(ROOM.replace("hand=", attributes + " hand="));
        SimulationSetup setup = base.setup();
        WallFollowing before = (WallFollowing) setup.controller();
        Command.ConfigureController change = change(before.withThreshold(threshold, value));
        String hash;
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            advance(simulation, CHANGE);
            simulation.execute(change);
            advance(simulation, setup.ticks());
            hash = hash(simulation);
        }
        assertNotEquals(base.run().trajectoryHash(), hash, "the threshold acts");
        assertEquals(hash, replay(base, runWith(base, change)));
        Path timed = folder.resolve("timed.xml");
        base.withSetup(setup.withTimeline(List.of(new TimedCommand(setup.timeOf(CHANGE + 1), change))))
                .save(timed);
        assertEquals(hash, Scenario.load(timed).run().trajectoryHash());
        String element = "<controller at=\"" + setup.timeOf(CHANGE + 1) + "\" " + threshold.fileName() + "=\"" + value;
        String byHand = Files.readString(folder.resolve("room.xml"))
                .replace("</scenario>", "<timeline>" + element + "\"/></timeline></scenario>");
        assertEquals(hash, scenario(byHand).run().trajectoryHash());
    }

    @Test
    void theInverseRestoresEveryThreshold() throws Exception {
        Scenario base = scenario(ROOM);
        WallFollowing before = (WallFollowing) base.setup().controller();
        Thresholds other = Thresholds.DEFAULT;
        for (Threshold threshold : Threshold.values()) {
            other = other.with(threshold, (threshold.quantity().max() + threshold.defaultValue()) / 2);
        }
        try (Simulation simulation = new Simulation(base.setup(), ControllerMode.DIRECT)) {
            advance(simulation, CHANGE);
            CommandResult result = simulation.execute(change(before.withThresholds(other)));
            assertEquals(other, ((WallFollowing) simulation.controllerSpec()).thresholds());
            simulation.execute(result.inverse().get(0));
            assertEquals(before, simulation.controllerSpec());
            advance(simulation, base.setup().ticks());
            assertEquals(base.run().trajectoryHash(), hash(simulation));
        }
    }

    @Test
    void aMarginMakesTheRobotTurnThatMuchEarlier() throws Exception {
        double nearer = distanceOfFirstTurn(ROOM);
        double farther = distanceOfFirstTurn(ROOM.replace("hand=", "aheadMargin=\"0.2\" hand="));
        assertEquals(nearer + 0.2, farther, 0.004);
    }

    @Test
    void aRobotThatTurnsEarlyFollowsAllWallsAndTrustsItsSensors() throws Exception {
        ScenarioRun run = scenario("<scenario xmlns=\"urn:faultline:scenario:1\" name=\"Room\" duration=\"120\">"
                        + "<world width=\"3.7\" height=\"2.6\"/><robot x=\"1.1\" y=\"1.2\" heading=\"31\"/>"
                        + "<controller aheadMargin=\"0.15\"/></scenario>")
                .run();
        assertTrue(run.collision().isEmpty());
        assertTrue(run.coverage().orElse(0) > 0.85, run.coverage().toString());
        assertEquals(List.of(), run.result().diagnosisEvents());
    }

    /** Returns how far from the enclosure the robot stands when its first turn begins. */
    private double distanceOfFirstTurn(String room) throws Exception {
        SimulationSetup setup =
                scenario(room.replace("heading=\"13\"", "heading=\"180\"")).setup();
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.telemetry().state() == FollowerState.SEARCH) {
                simulation.tick();
            }
            assertTrue(simulation.collision().isEmpty());
            return simulation.snapshot().pose().x();
        }
    }

    @Test
    void aThresholdOutOfItsBoundsIsRefused() {
        for (Threshold threshold : Threshold.values()) {
            for (double value : new double[] {
                Math.nextDown(threshold.quantity().min()),
                Math.nextUp(threshold.quantity().max()),
                Double.NaN
            }) {
                assertThrows(IllegalArgumentException.class, () -> Thresholds.DEFAULT.with(threshold, value));
            }
        }
    }
}
