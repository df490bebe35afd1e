package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Changes of a scenario whose run has executed edits of obstacles. These edits are not replayed if the change is about
 * something else. The judge is an editor of the changed scenario, which applies each edit.
 */
class ManyEditsTest {

    private static final int RUNS = Integer.getInteger("faultline.edits", 30);
    private static final int EDITS = 25;
    private static final List<String> IDS = List.of("box", "pole", "stool");
    private static final SimulationSetup BASE = SimulationSetup.of(
                    new WorldSpec(6, 4, true, 3, List.of(obstacle("box", 4, 2), obstacle("pole", 2, 3))),
                    new Pose(1, 1, 0))
            .withController(new ControllerSpec.None())
            .withDuration(60)
            .withTimeline(List.of(
                    new TimedCommand(0.1, new Command.MoveObstacle("box", new Pose(5, 3, 0))),
                    new TimedCommand(0.2, new Command.PlaceObstacle(obstacle("stool", 5, 1))),
                    new TimedCommand(0.3, new Command.RemoveObstacle("pole")),
                    new TimedCommand(0.4, new Command.MoveObstacle("stool", new Pose(3, 3, 0))),
                    new TimedCommand(0.6, new Command.PlaceObstacle(obstacle("pole", 3, 2)))));

    private static Obstacle obstacle(String id, double x, double y) {
        return new Obstacle(id, new ObstacleShape.CircleShape(0.1), new Pose(x, y, 0));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void aChangedEditorIsThatOfTheChangedScenario(int seed) {
        Random random = new Random(seed);
        for (int i = 0; i < RUNS; i++) {
            try (Simulation simulation = new Simulation(BASE, ControllerMode.DIRECT)) {
                SetupEditor editor = new SetupEditor(BASE);
                List<CommandResult> edits = edit(simulation, editor, random);
                SimulationSetup changed = changed(random);
                SetupEditor judge = new SetupEditor(changed);
                edits.forEach(judge::add);
                undo(edits, simulation, editor.rebased(changed.withTimeline(editor.timeline())), judge);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void editsAreUndoneAlsoAfterEventsAreOnTheTimeline(int seed) {
        Random random = new Random(seed);
        for (int i = 0; i < RUNS; i++) {
            try (Simulation simulation = new Simulation(BASE, ControllerMode.DIRECT)) {
                SetupEditor judge = new SetupEditor(BASE);
                judge.add(simulation.execute(new Command.InjectFault("front", new Fault.Dead())));
                List<CommandResult> edits = edit(simulation, judge, random);
                undo(edits, simulation, judge.withEventsOnTimeline(), judge);
            }
        }
    }

    /** Returns the base with another range of a sensor and, in some cases, with another duration. */
    private static SimulationSetup changed(Random random) {
        SensorSpec left = BASE.robot().sensor("left").orElseThrow();
        return BASE.withRobot(BASE.robot().withSensor(left.withRange(0.5)))
                .withDuration(random.nextBoolean() ? BASE.duration() : 90);
    }

    /** Executes random edits in a run, and returns their results. */
    private static List<CommandResult> edit(Simulation simulation, SetupEditor editor, Random random) {
        List<CommandResult> edits = new ArrayList<>();
        for (int i = 0; i < EDITS; i++) {
            for (int ticks = random.nextInt(8); ticks > 0; ticks--) {
                simulation.tick();
            }
            CommandResult result = simulation.execute(command(random));
            if (result.refusal().isEmpty() && !result.isNoOp()) {
                edits.add(EditedSetup.withoutSwitch(result));
                editor.add(result);
            }
        }
        return edits;
    }

    private static Command command(Random random) {
        String id = IDS.get(random.nextInt(IDS.size()));
        Pose pose = new Pose(2.5 + 3 * random.nextDouble(), 2 + 1.5 * random.nextDouble(), 0);
        return switch (random.nextInt(6)) {
            case 0 -> new Command.RemoveObstacle(id);
            case 1 -> new Command.PlaceObstacle(obstacle(id, pose.x(), pose.y()));
            case 2 ->
                new Command.ConfigureSensor(
                        BASE.robot().sensor("front").orElseThrow().withRange(0.3 + random.nextDouble()));
            default -> new Command.MoveObstacle(id, pose);
        };
    }

    /** Undoes edits, the last one first, and compares the setups before and after each. */
    private static void undo(List<CommandResult> edits, Simulation simulation, SetupEditor editor, SetupEditor judge) {
        assertEquals(judge.setup(), editor.setup());
        List<CommandResult> undone = new ArrayList<>(edits);
        Collections.reverse(undone);
        for (CommandResult edit : undone) {
            simulation.tick();
            for (Command inverse : edit.inverse()) {
                CommandResult result = simulation.execute(inverse);
                if (result.refusal().isEmpty()) {
                    editor.add(result);
                    judge.add(result);
                }
            }
            assertEquals(judge.setup(), editor.setup());
        }
    }
}
