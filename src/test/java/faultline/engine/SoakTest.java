package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.metrics.HeadlessRun;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Long runs with random faults, switches and edits: each replays from its journal to the same hash, and memory does not
 * grow. The system property {@code faultline.soak.hours} sets the simulated time, by default a few minutes.
 */
class SoakTest {

    private static final double HOURS = Double.parseDouble(System.getProperty("faultline.soak.hours", "0.1"));
    private static final double RUN_SECONDS = Math.min(3600, 3600 * HOURS / 3);
    private static final int TICKS_PER_COMMAND = 200;
    private static final long MAX_GROWTH = 64 << 20;

    private final SplittableRandom random = new SplittableRandom(4711);

    @Test
    void longRunsWithRandomCommandsReplayToTheSameHash() throws Exception {
        List<String> files = List.of("office.xml", "yard.xml", "noisy-sensors.xml", "pole-and-table-leg.xml");
        long accepted = 0;
        long before = -1;
        double simulated = 0;
        for (int i = 0; simulated < 3600 * HOURS; i++) {
            Scenario scenario = Scenario.loadShipped(files.get(i % files.size()));
            SimulationSetup setup = scenario.setup().withSeed(random.nextLong()).withDuration(RUN_SECONDS);
            Journal journal;
            long hash;
            try (Simulation run = new Simulation(setup, ControllerMode.DIRECT)) {
                for (long tick = 0; tick < setup.ticks(); tick++) {
                    if (tick % TICKS_PER_COMMAND == 0) {
                        accepted += run.execute(command(run)).refusal().isEmpty() ? 1 : 0;
                    }
                    run.tick();
                }
                journal = run.journal();
                hash = run.trajectoryHash();
            }
            SimulationSetup replay = JournalScenario.create(scenario, journal).setup();
            assertEquals(
                    hash,
                    HeadlessRun.run(replay, ControllerMode.DIRECT, List.of()).trajectoryHash(),
                    "run " + i);
            simulated += RUN_SECONDS;
            long used = usedMemory();
            before = i == files.size() ? used : before;
            assertTrue(before < 0 || used < before + MAX_GROWTH, used + " bytes are in use, before " + before);
        }
        assertTrue(accepted > 10, accepted + " commands were accepted");
    }

    private static long usedMemory() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }

    private Command command(Simulation run) {
        String sensor = run.robot()
                .sensors()
                .get(random.nextInt(run.robot().sensors().size()))
                .id();
        Pose pose = new Pose(random.nextDouble(12), random.nextDouble(8), random.nextDouble(6));
        List<Obstacle> obstacles = run.snapshot().obstacles();
        return switch (random.nextInt(6)) {
            case 0 -> {
                FaultKind kind = FaultKind.values()[random.nextInt(FaultKind.values().length)];
                yield new Command.InjectFault(sensor, kind.createFault(kind.defaultValue(), FaultKind.DEFAULT_LENGTH));
            }
            case 1, 2 -> new Command.ClearFaults(sensor);
            case 3 -> new Command.SwitchSensor(sensor, random.nextBoolean());
            case 4 ->
                new Command.MoveObstacle(
                        obstacles.get(random.nextInt(obstacles.size())).id(), pose);
            default ->
                new Command.PlaceObstacle(new Obstacle(
                        "soak" + random.nextInt(3),
                        random.nextBoolean()
                                ? new ObstacleShape.CircleShape(0.02 + 0.2 * random.nextDouble())
                                : new ObstacleShape.WallShape(List.of(Vector2.ZERO, new Vector2(1, 0))),
                        pose));
        };
    }
}
