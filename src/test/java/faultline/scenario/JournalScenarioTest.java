package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a run with commands from outside is saved as a scenario file and replayed from it. */
class JournalScenarioTest {

    private static final Map<Integer, Command> COMMANDS = Map.of(
            37, new Command.SwitchSensor("rear", false),
            411, new Command.InjectFault("front-right", new Fault.Bias(1.0 / 3)),
            777,
                    new Command.PlaceObstacle(new Obstacle(
                            "box", new ObstacleShape.RectangleShape(0.3, 0.1 + 0.2), new Pose(0.5, 2, 1.0 / 7))),
            1203, new Command.MoveObstacle("box", new Pose(0.9, 2.1, 2.0 / 7)),
            1500, new Command.SetPlatform(0.24, 0.19, 0.25),
            1999,
                    new Command.ConfigureSensor(
                            RobotSpec.DEFAULT.sensors().get(1).withRange(0.7).withCone(0.5)),
            2500, new Command.RemoveObstacle("box"),
            2501, new Command.ClearFaults("front-right"));

    @Test
    void aSavedJournalReplaysExactly(@TempDir Path folder) throws Exception {
        Scenario scenario = Scenario.load(Path.of("scenarios/inner-corner-90.xml"));
        Journal journal;
        String hash;
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            while (simulation.ticks() < 3333) {
                Command command = COMMANDS.get((int) simulation.ticks());
                if (command != null) {
                    assertEquals(Optional.empty(), simulation.execute(command).refusal());
                }
                simulation.tick();
            }
            journal = simulation.journal();
            hash = String.format(Locale.ROOT, "%016x", simulation.trajectoryHash());
        }
        Path file = folder.resolve("journal.xml");
        JournalScenario.create(scenario, journal).save(file);
        ScenarioRun replay = Scenario.load(file).run();
        assertEquals(3333, replay.result().ticks());
        assertEquals(hash, replay.trajectoryHash());
        assertNotEquals(
                hash,
                scenario.withSetup(scenario.setup().withDuration(33.33)).run().trajectoryHash());
    }

    /** A drag may turn the robot to -0, whose sine is -0, too. */
    @Test
    void aStartAtMinusZeroReplaysExactly(@TempDir Path folder) throws Exception {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        Pose start = yard.setup().start();
        Scenario scenario = yard.withSetup(yard.setup().withStart(new Pose(start.x(), start.y(), -0.0)));
        Path file = folder.resolve("start.xml");
        scenario.save(file);
        assertEquals(scenario.run().trajectoryHash(), Scenario.load(file).run().trajectoryHash());
    }

    @Test
    void theTimesOfAJournalLeadBackToItsTicks() throws ScenarioException {
        Scenario scenario = Scenario.load(Path.of("scenarios/every-fault.xml"));
        for (long tick = 0; tick < 2_000_000; tick += 97) {
            assertEquals(tick, scenario.setup().tickAt(tick * scenario.setup().dt()));
        }
    }

    /** The product of 3591 and 0.01 is 35.910000000000004. */
    @Test
    void theTimesOfAJournalHaveNoRoundingError() throws ScenarioException {
        Scenario scenario = Scenario.load(Path.of("scenarios/yard.xml"));
        Journal.Entry entry = new Journal.Entry(3591, new Command.ClearFaults("front"));
        Scenario replay = JournalScenario.create(scenario, new Journal(scenario.setup(), List.of(entry), 4000));
        assertEquals(35.91, replay.setup().timeline().get(0).time());
    }
}
