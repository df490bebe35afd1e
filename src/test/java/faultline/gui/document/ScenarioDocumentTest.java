package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Refusal;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A scenario that is edited, compared with its file. */
class ScenarioDocumentTest {

    private static final List<String> IDS = List.of("a", "b", "c");

    @Test
    void aRecordOfARunWhoseOnlyEditIsUndoneIsARecordAgain() throws ScenarioException {
        Scenario office = Scenario.load(Path.of("scenarios/office.xml"));
        Scenario saved = new Scenario(office.name(), office.description(), true, office.setup(), office.expectation());
        ScenarioDocument document = new ScenarioDocument(Path.of("saved.xml"), saved, saved);
        document.change(open -> open.withSetup(open.setup().withSeed(7)));
        assertTrue(document.isChanged());
        assertFalse(document.edited().recorded());
        document.change(open -> open.withSetup(office.setup()));
        assertEquals(saved, document.edited());
        assertFalse(document.isChanged());
    }

    @Test
    void statesThatAnotherControllerDoesNotHaveAreNotExpected() throws ScenarioException, IOException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        ScenarioDocument document = new ScenarioDocument(Path.of("saved.xml"), visitors, visitors);
        document.commandsExecuted(List.of(executed(1, new Command.ConfigureController(new ControllerSpec.None()))));
        document.edited().toBytes();
        assertEquals(
                List.of(new Expectation.Collides(false)),
                document.edited().expectation().conditions());
        ControllerSpec.WallFollowing before =
                (ControllerSpec.WallFollowing) visitors.setup().controller();
        ScenarioDocument restarted = new ScenarioDocument(null, null, document.edited());
        restarted.continueFrom(document);
        assertEquals(document.edited(), restarted.edited());
        for (ScenarioDocument undone : List.of(document, restarted)) {
            undone.commandsExecuted(List.of(executed(2, new Command.ConfigureController(before))));
            assertEquals(visitors, undone.edited());
        }
        ScenarioDocument changed = new ScenarioDocument(null, null, visitors.withExpectation(Expectation.NONE));
        changed.continueFrom(document);
        assertEquals(Expectation.NONE, changed.edited().expectation());
    }

    /** The expectation is edited while another controller drives, and then the choice of that controller is undone. */
    @Test
    void statesOfTheControllerThatIsUndoneAreNotExpected() throws ScenarioException, IOException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        ControllerSpec.None none = new ControllerSpec.None();
        ControllerSpec.WallFollowing follower =
                (ControllerSpec.WallFollowing) visitors.setup().controller();
        Scenario still =
                visitors.withSetup(visitors.setup().withController(none)).withExpectation(Expectation.NONE);
        ScenarioDocument document = new ScenarioDocument(null, still, still);
        document.commandsExecuted(List.of(executed(1, new Command.ConfigureController(follower))));
        document.change(open -> open.withExpectation(visitors.expectation()));
        assertEquals(visitors.expectation(), document.edited().expectation());
        document.commandsExecuted(List.of(executed(2, new Command.ConfigureController(none))));
        document.edited().toBytes();
        JournalScenario.create(document.initial(), document.journal(2)).toBytes();
    }

    @Test
    void statesOfAControllerOfTheTimelineStayExpected() throws ScenarioException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        ControllerSpec follower = visitors.setup().controller();
        Scenario late = visitors.withSetup(visitors.setup()
                .withController(new ControllerSpec.Drive(1, 1))
                .withTimeline(List.of(new SimulationSetup.TimedCommand(
                        2, new Command.ConfigureController((ControllerSpec.BuiltIn) follower)))));
        ScenarioDocument document = new ScenarioDocument(null, late, late);
        document.commandsExecuted(List.of(executed(1, new Command.ConfigureController(new ControllerSpec.None()))));
        assertEquals(visitors.expectation(), document.edited().expectation());
    }

    private static CommandResult executed(long tick, Command command) {
        return new CommandResult.Executed(tick, command, List.of());
    }

    /** In this scenario the timeline moves a crate, and places and removes a parcel. */
    @Test
    void hiddenCommandsReturnAfterARestart() throws ScenarioException, IOException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        Obstacle crate = visitors.setup().world().obstacles().get(3);
        ScenarioDocument document = new ScenarioDocument(Path.of("saved.xml"), visitors, visitors);
        document.commandsExecuted(List.of(
                executed(500, new Command.RemoveObstacle("crate")),
                executed(2500, new Command.RemoveObstacle("parcel"))));
        assertEquals(List.of(), document.edited().setup().timeline());
        document.edited().toBytes();
        ScenarioDocument restarted = new ScenarioDocument(null, null, document.edited());
        restarted.continueFrom(document);
        assertEquals(document.edited(), restarted.edited());
        restarted.commandsExecuted(List.of(executed(300, new Command.PlaceObstacle(crate))));
        assertEquals(
                visitors.setup().timeline().subList(0, 1),
                restarted.edited().setup().timeline());
        assertEquals(visitors.setup().world(), restarted.edited().setup().world());
        Obstacle parcel =
                ((Command.PlaceObstacle) visitors.setup().timeline().get(1).command()).obstacle();
        restarted.commandsExecuted(List.of(executed(3000, new Command.PlaceObstacle(parcel))));
        assertEquals(visitors, restarted.edited());
        assertFalse(restarted.isChanged());
    }

    /** A visitor is removed, and a sensor and the platform are changed; then the run is restarted and all is undone. */
    @Test
    void undoAfterARestartGivesBackWhatTheScenarioHad() throws ScenarioException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        ScenarioDocument document = new ScenarioDocument(Path.of("saved.xml"), visitors, visitors);
        List<Command> edits = List.of(
                new Command.RemoveObstacle("visitor-1"),
                new Command.ConfigureSensor(
                        visitors.setup().robot().sensors().get(0).withRange(0.4)),
                new Command.SetPlatform(0.2, 0.15, 0.1));
        List<CommandResult> inverses = new ArrayList<>();
        try (Simulation run = new Simulation(visitors.setup(), ControllerMode.DIRECT)) {
            tickUntil(run, 900);
            for (Command command : edits) {
                CommandResult result = run.execute(command);
                document.commandsExecuted(List.of(result));
                inverses.add(0, inverse(result));
            }
        }
        ScenarioDocument restarted = new ScenarioDocument(null, null, document.edited());
        restarted.continueFrom(document);
        assertEquals(
                List.of("visitor-2", "visitor-3", "crate"),
                restarted.edited().setup().world().obstacles().stream()
                        .map(Obstacle::id)
                        .toList());
        restarted.changeStart(inverses, false);
        assertEquals(visitors, restarted.edited());
        assertEquals(visitors, restarted.initial());
    }

    /** The parcel is moved; then the run is restarted, and a command is added before that which places the parcel. */
    @Test
    void undoAfterARestartFindsAnObstacleWhoseCommandHasAnotherIndex() throws ScenarioException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        ScenarioDocument document = new ScenarioDocument(null, visitors, visitors);
        CommandResult move = new CommandResult.Executed(
                2500,
                new Command.MoveObstacle("parcel", new Pose(1, 1, 0)),
                List.of(new Command.MoveObstacle("parcel", new Pose(4, 2, 0))));
        document.commandsExecuted(List.of(move));
        ScenarioDocument restarted = new ScenarioDocument(null, null, document.edited());
        restarted.continueFrom(document);
        TimedCommand added = new TimedCommand(1, new Command.RemoveObstacle("visitor-1"));
        restarted.change(open -> withTimeline(open, with(added, open.setup().timeline())));
        restarted.changeStart(List.of(inverse(move)), false);
        assertEquals(
                with(added, visitors.setup().timeline()),
                restarted.edited().setup().timeline());
    }

    private static CommandResult inverse(CommandResult result) {
        return new CommandResult.Executed(result.tick(), result.inverse().get(0), List.of(result.command()));
    }

    private static List<TimedCommand> with(TimedCommand first, List<TimedCommand> others) {
        List<TimedCommand> commands = new ArrayList<>(others);
        commands.add(0, first);
        return commands;
    }

    @Test
    void commandsAboutAnObstacleThatIsNoLongerPlacedAreHidden() throws ScenarioException, IOException {
        Scenario visitors = Scenario.load(Path.of("scenarios/three-visitors.xml"));
        List<TimedCommand> before = visitors.setup().timeline();
        ScenarioDocument document = new ScenarioDocument(null, visitors, visitors);
        document.change(open -> withTimeline(open, List.of(before.get(0), before.get(2))));
        document.edited().toBytes();
        assertEquals(before.subList(0, 1), document.edited().setup().timeline());
        document.change(open -> withTimeline(open, before));
        assertEquals(visitors, document.edited());
    }

    private static Scenario withTimeline(Scenario scenario, List<TimedCommand> timeline) {
        return scenario.withSetup(scenario.setup().withTimeline(timeline));
    }

    /** Writing a scenario fails if it does not read back as the same one. */
    @Test
    void whateverIsEditedCanBeSaved() throws IOException {
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            Scenario start = randomScenario(random);
            ScenarioDocument document = new ScenarioDocument(null, start, start);
            long tick = 0;
            for (int i = 0; i < 12; i++) {
                tick += random.nextInt(120);
                int kind = random.nextInt(8);
                if (kind == 0) {
                    document.change(open -> open.withSetup(open.setup().withSeed(random.nextInt())));
                } else if (kind == 1) {
                    ScenarioDocument restarted = new ScenarioDocument(null, null, document.edited());
                    restarted.continueFrom(document);
                    document = restarted;
                    tick = 0;
                } else {
                    document.commandsExecuted(List.of(execute(randomCommand(random), document, tick)));
                }
                document.edited().toBytes();
                JournalScenario.create(document.initial(), document.journal(tick))
                        .toBytes();
            }
        }
    }

    /** Executes a command at a tick of the run of a document. Each of the commands before finds its obstacle. */
    private static CommandResult execute(Command command, ScenarioDocument document, long tick) {
        try (Simulation run = new Simulation(document.initial().setup(), ControllerMode.DIRECT)) {
            for (Journal.Entry entry : document.journal(tick).entries()) {
                tickUntil(run, entry.tick() - 1);
                Optional<Refusal.Reason> reason =
                        run.execute(entry.command()).refusal().map(Refusal::reason);
                assertNotEquals(Optional.of(Refusal.Reason.UNKNOWN_OBSTACLE), reason, entry.toString());
            }
            tickUntil(run, tick);
            return run.execute(command);
        }
    }

    private static void tickUntil(Simulation run, long tick) {
        while (run.ticks() < tick) {
            run.tick();
        }
    }

    private static Scenario randomScenario(Random random) {
        List<Obstacle> atStart = new ArrayList<>();
        List<TimedCommand> timeline = new ArrayList<>();
        for (String id : IDS) {
            Obstacle obstacle = randomObstacle(id, random);
            if (random.nextBoolean()
                    && !(obstacle.isMoving() && atStart.stream().anyMatch(Obstacle::isMoving))) {
                atStart.add(obstacle);
            }
        }
        IDS.forEach(id -> timeline.add(
                new TimedCommand(random.nextInt(100), new Command.PlaceObstacle(randomObstacle(id, random)))));
        for (int i = 0; i < 6; i++) {
            timeline.add(new TimedCommand(random.nextInt(100), randomCommand(random)));
        }
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(6, 4, true, 1, atStart), new Pose(1, 1, 0));
        SimulationSetup busy =
                setup.withTick(0.1).withController(new ControllerSpec.None()).withTimeline(timeline);
        return new Scenario("random", "", false, busy, Expectation.NONE);
    }

    private static Command randomCommand(Random random) {
        String id = IDS.get(random.nextInt(IDS.size()));
        Obstacle obstacle = randomObstacle(id, random);
        return switch (random.nextInt(3)) {
            case 0 -> new Command.MoveObstacle(id, obstacle.pose());
            case 1 -> new Command.RemoveObstacle(id);
            default -> new Command.PlaceObstacle(obstacle);
        };
    }

    private static Obstacle randomObstacle(String id, Random random) {
        Pose pose = new Pose(2 + random.nextInt(4), 1 + random.nextInt(3), 0);
        Obstacle still = new Obstacle(id, new ObstacleShape.CircleShape(0.1), pose);
        return random.nextInt(3) > 0
                ? still
                : still.withMotion(new WaypointPath(0.1, true, List.of(new Vector2(3, 2), new Vector2(4, 2))));
    }
}
