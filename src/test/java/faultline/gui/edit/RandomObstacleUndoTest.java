package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.gui.document.SessionFrames;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Random moves, new sizes, removals and new ids of obstacles that the timeline moves, replaces and removes as well,
 * with undo, redo, moves of the run and restarts. When everything is undone, the scenario is the first one, and the run
 * is a run of it. The system property {@code faultline.edits} sets the number of sequences.
 */
@ExtendWith(EdtChecker.class)
class RandomObstacleUndoTest {

    private static final int SEEDS = Integer.getInteger("faultline.edits", 10);
    private static final int STEPS = 14;
    private static final int PLANNED_COMMANDS = 3;
    private static final int PLANNED_TICKS = 100;
    private static final List<String> IDS = List.of("coat-stand", "chair-1");
    /** The ids that the edited obstacles may have. */
    private static final List<String> NAMES = List.of("coat-stand", "chair-1", "stool", "pole");

    private final EditedRun run = new EditedRun();
    private final Map<String, Obstacle> originals = run.scenario().setup().world().obstacles().stream()
            .filter(obstacle -> IDS.contains(obstacle.id()))
            .collect(Collectors.toMap(Obstacle::id, Function.identity()));
    private final List<String> steps = new ArrayList<>();

    @AfterEach
    void close() {
        run.close();
    }

    static Stream<Integer> seeds() {
        return IntStream.range(0, SEEDS).boxed();
    }

    private static Pose pose(Random random) {
        return new Pose(3 + random.nextInt(20) / 10.0, 4 + random.nextInt(6) / 10.0, 0);
    }

    private static Command place(Obstacle obstacle, Pose pose, Random random) {
        double radius = 0.05 + random.nextInt(5) / 100.0;
        return new Command.PlaceObstacle(new Obstacle(obstacle.id(), new ObstacleShape.CircleShape(radius), pose));
    }

    private SimulationSetup plan(Random random) {
        List<TimedCommand> timeline = IntStream.range(0, PLANNED_COMMANDS)
                .mapToObj(i -> new TimedCommand((1 + random.nextInt(PLANNED_TICKS)) / 100.0, plannedCommand(random)))
                .sorted(Comparator.comparingDouble(TimedCommand::time))
                .toList();
        run.plan(timeline);
        return run.scenario().setup();
    }

    private Command plannedCommand(Random random) {
        Obstacle obstacle = originals.get(IDS.get(random.nextInt(IDS.size())));
        return switch (random.nextInt(4)) {
            case 0 -> place(obstacle, pose(random), random);
            case 1 -> new Command.RemoveObstacle(obstacle.id());
            default -> new Command.MoveObstacle(obstacle.id(), pose(random));
        };
    }

    private void step(Random random) {
        int kind = random.nextInt(18);
        if (kind < 4) {
            edit(random);
        } else if (kind < 6) {
            undo();
        } else if (kind == 6) {
            undoTwiceAtOnce();
        } else if (kind < 9) {
            note("redo " + callOnEdt(run.edits()::redoName));
            run.redo();
        } else if (kind < 12) {
            int ticks = 1 + random.nextInt(31);
            note("advance by " + ticks);
            run.advance(ticks);
        } else if (kind == 12) {
            note("restart");
            run.restart();
        } else if (kind < 16) {
            rename(random);
        } else {
            long tick = random.nextInt((int) run.tick() + 20);
            note("move to " + tick);
            run.seek(tick);
        }
    }

    /** Edits an obstacle that is there, as a user does, if the edit changes it. */
    private void edit(Random random) {
        Optional<Obstacle> shown = find(shownObstacles(), NAMES.get(random.nextInt(NAMES.size())));
        if (shown.isEmpty()) {
            return;
        }
        Obstacle obstacle = shown.get();
        Command command =
                switch (random.nextInt(4)) {
                    case 0 -> place(obstacle, obstacle.pose(), random);
                    case 1 -> new Command.RemoveObstacle(obstacle.id());
                    default -> new Command.MoveObstacle(obstacle.id(), pose(random));
                };
        if (!command.equals(new Command.PlaceObstacle(obstacle))
                && !command.equals(new Command.MoveObstacle(obstacle.id(), obstacle.pose()))) {
            note(command.toString());
            run.send(command);
        }
    }

    /** Gives an obstacle that is there another id, unless that is taken. */
    private void rename(Random random) {
        String id = NAMES.get(random.nextInt(NAMES.size()));
        String newId = NAMES.get(random.nextInt(NAMES.size()));
        if (find(shownObstacles(), id).isPresent() && run.rename(id, newId).isEmpty()) {
            note("rename " + id + " to " + newId);
        }
    }

    private void undo() {
        note("undo " + callOnEdt(run.edits()::undoName));
        run.undo();
    }

    private void undoTwiceAtOnce() {
        note("undo twice");
        runOnEdt(() -> {
            run.edits().undo();
            run.edits().undo();
        });
        run.rest();
    }

    private void undoAll() {
        while (callOnEdt(run.edits()::canUndo)) {
            undo();
        }
    }

    private void note(String step) {
        steps.add("tick " + run.tick() + ": " + step);
    }

    private List<Obstacle> shownObstacles() {
        return SessionFrames.frame(run.workspace()).snapshot().obstacles();
    }

    private static Optional<Obstacle> find(Collection<Obstacle> obstacles, String id) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
    }

    /** Returns the obstacles that are edited; one whose removal was undone is above others that were below it. */
    private static List<Optional<Obstacle>> edited(Collection<Obstacle> obstacles) {
        return IDS.stream().map(id -> find(obstacles, id)).toList();
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void withoutEditsTheScenarioIsTheFirstOneAndTheRunIsOneOfIt(int seed) {
        Random random = new Random(seed);
        SimulationSetup planned = plan(random);
        long last = PLANNED_TICKS;
        for (int i = 0; i < STEPS; i++) {
            step(random);
            last = Math.max(last, run.tick());
        }
        undoAll();
        // Edits that are ahead are done again on the way.
        run.advanceTo(last + 2);
        undoAll();
        run.advance(2);
        String sequence = "seed " + seed + ": " + planned.timeline() + steps;
        SimulationSetup now = run.scenario().setup();
        assertEquals(edited(planned.world().obstacles()), edited(now.world().obstacles()), sequence);
        assertEquals(planned.timeline(), now.timeline(), sequence);
        try (Session replayed = Session.replay(new Journal(planned, List.of(), 0), run.tick(), tick -> true)) {
            assertEquals(edited(replayed.frame().snapshot().obstacles()), edited(shownObstacles()), sequence);
        }
    }
}
