package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Commands of the timeline about an obstacle that has been removed: void if the user has removed it. */
class VoidCommandsTest {

    private static final String ID = "pole";
    private static final Command MOVE = new Command.MoveObstacle(ID, new Pose(2, 3, 0));
    private static final Command REMOVE = new Command.RemoveObstacle(ID);
    private static final String UNKNOWN = "there is no obstacle " + ID;

    private final List<String> handled = new ArrayList<>();
    private Scenario scenario;
    private SimulationSetup setup;

    @BeforeEach
    void load() throws Exception {
        scenario = Scenario.load(Path.of("scenarios/collision-on-purpose.xml"));
        setup = scenario.setup();
    }

    private Simulation start(TimedCommand... timeline) {
        return new Simulation(setup.withTimeline(List.of(timeline)), ControllerMode.DIRECT, this::note);
    }

    private void note(CommandResult result) {
        handled.add(result.tick() + " "
                + result.refusal()
                        .map(refusal -> refusal.message())
                        .orElse(result.command().getClass().getSimpleName()));
    }

    private static void tickTo(Simulation simulation, long tick) {
        while (simulation.ticks() < tick) {
            simulation.tick();
        }
    }

    @Test
    void aCommandAboutAnObstacleThatWasRemovedFromOutsideIsNotReported() {
        try (Simulation simulation = start(new TimedCommand(0.1, MOVE), new TimedCommand(0.2, REMOVE))) {
            tickTo(simulation, 4);
            simulation.execute(REMOVE);
            tickTo(simulation, 25);
            simulation.execute(MOVE);
            assertEquals(List.of("5 RemoveObstacle", "26 " + UNKNOWN), handled);
        }
    }

    @Test
    void aCommandAboutAnObstacleThatTheTimelineHasRemovedIsReported() {
        try (Simulation simulation = start(new TimedCommand(0.1, REMOVE), new TimedCommand(0.2, MOVE))) {
            tickTo(simulation, 25);
            assertEquals(List.of("10 RemoveObstacle", "20 " + UNKNOWN), handled);
        }
    }

    @Test
    void aCommandIsReportedAgainAfterTheObstacleHasBeenReturned() {
        Obstacle pole = setup.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(ID))
                .findFirst()
                .orElseThrow();
        try (Simulation simulation =
                start(new TimedCommand(0.1, MOVE), new TimedCommand(0.2, REMOVE), new TimedCommand(0.3, MOVE))) {
            simulation.execute(REMOVE);
            simulation.execute(new Command.PlaceObstacle(pole));
            tickTo(simulation, 35);
            assertEquals(
                    List.of(
                            "1 RemoveObstacle",
                            "1 PlaceObstacle",
                            "10 MoveObstacle",
                            "20 RemoveObstacle",
                            "30 " + UNKNOWN),
                    handled);
        }
    }

    /** The file of a run has the removal on its timeline. */
    @Test
    void aRunAndItsJournalHaveTheSameTrajectory() {
        TimedCommand move = new TimedCommand(0.1, MOVE);
        long hash;
        try (Simulation simulation = start(move)) {
            tickTo(simulation, 4);
            simulation.execute(REMOVE);
            tickTo(simulation, 40);
            hash = simulation.trajectoryHash();
        }
        handled.clear();
        try (Simulation simulation = start(new TimedCommand(setup.timeOf(5), REMOVE), move)) {
            tickTo(simulation, 40);
            assertEquals(hash, simulation.trajectoryHash());
            assertEquals(List.of("5 RemoveObstacle", "10 " + UNKNOWN), handled, "a file says what it does");
        }
    }

    @Test
    void aSavedJournalHasNoCommandsThatWereVoid() {
        Obstacle pole = setup.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(ID))
                .findFirst()
                .orElseThrow();
        TimedCommand put = new TimedCommand(0.3, new Command.PlaceObstacle(pole));
        TimedCommand remove = new TimedCommand(0.4, REMOVE);
        TimedCommand mistake = new TimedCommand(0.5, MOVE);
        Journal journal;
        long hash;
        // Not in the order of their times.
        try (Simulation simulation =
                start(mistake, new TimedCommand(0.2, MOVE), new TimedCommand(0.1, MOVE), put, remove)) {
            tickTo(simulation, 15);
            simulation.execute(REMOVE);
            tickTo(simulation, 60);
            journal = simulation.journal();
            hash = simulation.trajectoryHash();
        }
        assertEquals(
                List.of(
                        "10 MoveObstacle",
                        "16 RemoveObstacle",
                        "30 PlaceObstacle",
                        "40 RemoveObstacle",
                        "50 " + UNKNOWN),
                handled);
        List<String> before = List.copyOf(handled);
        handled.clear();
        SimulationSetup replay = JournalScenario.create(scenario, journal).setup();
        assertEquals(
                List.of(mistake, new TimedCommand(0.1, MOVE), put, remove, new TimedCommand(0.16, REMOVE)),
                replay.timeline());
        try (Simulation simulation = new Simulation(replay, ControllerMode.DIRECT, this::note)) {
            tickTo(simulation, 60);
            assertEquals(hash, simulation.trajectoryHash());
            assertEquals(before, handled);
        }
    }

    /** In a tick, the commands of the timeline come before those from outside. */
    @Test
    void aCommandInTheTickOfTheRemovalWasNotVoid() {
        TimedCommand move = new TimedCommand(0.05, MOVE);
        try (Simulation simulation = start(move)) {
            tickTo(simulation, 4);
            simulation.execute(REMOVE);
            tickTo(simulation, 10);
            assertEquals(List.of("5 MoveObstacle", "5 RemoveObstacle"), handled);
            assertEquals(
                    List.of(move, new TimedCommand(0.05, REMOVE)),
                    JournalScenario.create(scenario, simulation.journal())
                            .setup()
                            .timeline());
        }
    }
}
