package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Same setup, same commands: the same bits in every tick, whoever runs it and whoever looks on. */
@Timeout(value = 2, unit = TimeUnit.MINUTES)
class DeterminismTest {

    private static final int TICKS = 3000;
    private static final int COMMANDS = 2000;

    @Test
    void theControllersThreadMakesNoDifferenceInAnyTick() {
        assertArrayEquals(
                hashesPerTick(busyRoom(1), ControllerMode.DIRECT),
                hashesPerTick(busyRoom(1), ControllerMode.OWN_THREAD));
    }

    @Test
    void neitherDoesHavingRunBefore() {
        long[] first = hashesPerTick(busyRoom(2), ControllerMode.DIRECT);
        for (int run = 0; run < 5; run++) {
            assertArrayEquals(first, hashesPerTick(busyRoom(2), ControllerMode.DIRECT));
        }
    }

    @Test
    void blindCollisionsRepeatToo() {
        RandomWorlds first = new RandomWorlds(51, RobotSpec.DEFAULT, 3);
        RandomWorlds again = new RandomWorlds(51, RobotSpec.DEFAULT, 3);
        for (int i = 0; i < 5; i++) {
            assertArrayEquals(
                    hashesPerTick(first.nextSetup(3), ControllerMode.DIRECT),
                    hashesPerTick(again.nextSetup(3), ControllerMode.OWN_THREAD));
        }
    }

    @Test
    void anotherSeedGivesAnotherRunWhereThereIsNoise() {
        assertNotEquals(
                hashes(busyRoom(1)).lastEntry().getValue(),
                hashes(busyRoom(2)).lastEntry().getValue());
    }

    @Test
    void aBusyReaderOfFramesChangesNothingAndSeesOnlyTrueMoments() throws Exception {
        Map<Long, Long> truth = hashes(busyRoom(3));
        try (Session session = Session.start(busyRoom(3))) {
            session.setSpeed(Double.POSITIVE_INFINITY);
            session.resume();
            Map<Long, Long> seen = new TreeMap<>();
            long tick = 0;
            while (tick < TICKS) {
                Frame frame = session.frame().frame();
                tick = frame.snapshot().tick();
                if (tick <= TICKS) {
                    seen.put(tick, frame.trajectoryHash());
                }
            }
            assertTrue(seen.size() > 10, "too few frames for this test: " + seen.size());
            seen.forEach((when, hash) -> assertEquals(truth.get(when), hash, () -> "at tick " + when));
        }
    }

    @Test
    void theJournalOfALivelySessionReplaysToTheBit() throws Exception {
        SplittableRandom random = new SplittableRandom(52);
        try (Session session = Session.start(busyRoom(4))) {
            session.setSpeed(Double.POSITIVE_INFINITY);
            session.resume();
            for (int sent = 0; sent < COMMANDS; sent++) {
                session.send(randomCommand(random));
                long reached = session.frame().frame().snapshot().tick();
                while (sent % 10 == 0 && session.frame().frame().snapshot().tick() == reached) {
                    Thread.onSpinWait();
                }
            }
            session.pause();
            Journal journal = session.journal().get(10, TimeUnit.SECONDS);
            while (journal.entries().size() + session.status().refusals() < COMMANDS) {
                Thread.onSpinWait();
            }
            assertEquals(
                    COMMANDS,
                    journal.entries().size() + session.status().refusals(),
                    "every command is either done or refused");
            assertFalse(journal.entries().isEmpty());
            while (session.frame().frame().snapshot().tick() < journal.ticks()) {
                Thread.onSpinWait();
            }
            assertEquals(session.frame().frame().trajectoryHash(), replay(journal));
        }
    }

    private static long replay(Journal journal) {
        try (Simulation simulation = new Simulation(journal.setup(), ControllerMode.DIRECT)) {
            while (simulation.ticks() < journal.ticks()) {
                for (Journal.Entry entry : journal.entries()) {
                    if (entry.tick() == simulation.ticks() + 1) {
                        assertEquals(
                                Optional.empty(),
                                simulation.execute(entry.command()).refusal());
                    }
                }
                simulation.tick();
            }
            return simulation.trajectoryHash();
        }
    }

    private static Command randomCommand(SplittableRandom random) {
        String sensor = RobotSpec.DEFAULT.sensors().get(random.nextInt(8)).id();
        return switch (random.nextInt(6)) {
            case 0 -> new Command.SwitchSensor(sensor, random.nextBoolean());
            case 1 -> new Command.InjectFault(sensor, new Fault.Bias(random.nextDouble(-0.1, 0.1)));
            case 2 -> new Command.ClearFaults(sensor);
            case 3 ->
                new Command.MoveObstacle(
                        "desk", new Pose(random.nextDouble(4), random.nextDouble(3), random.nextDouble(7)));
            case 4 -> new Command.SetPlatform(0.25, random.nextDouble(0.15, 0.22), random.nextDouble(0.1, 0.4));
            default ->
                new Command.ConfigureSensor(
                        RobotSpec.DEFAULT.sensor(sensor).orElseThrow().withRange(random.nextDouble(0.3, 1)));
        };
    }

    /** The raw bits of everything that the hash covers, tick by tick. */
    private static long[] hashesPerTick(SimulationSetup setup, ControllerMode mode) {
        LongStream.Builder bits = LongStream.builder();
        try (Simulation simulation = new Simulation(setup, mode)) {
            for (int tick = 0; tick < TICKS; tick++) {
                simulation.tick();
                Pose pose = simulation.pose();
                for (double value : new double[] {
                    pose.x(),
                    pose.y(),
                    pose.heading(),
                    simulation.wheelSpeeds().left(),
                    simulation.wheelSpeeds().right()
                }) {
                    bits.add(Double.doubleToRawLongBits(value));
                }
                for (int sensor = 0; sensor < setup.robot().sensors().size(); sensor++) {
                    bits.add(Double.doubleToRawLongBits(simulation.reportedReading(sensor)));
                }
                bits.add(simulation.trajectoryHash());
            }
        }
        return bits.build().toArray();
    }

    private static TreeMap<Long, Long> hashes(SimulationSetup setup) {
        TreeMap<Long, Long> hashes = new TreeMap<>();
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            hashes.put(0L, simulation.trajectoryHash());
            for (int tick = 0; tick < TICKS; tick++) {
                simulation.tick();
                hashes.put(simulation.ticks(), simulation.trajectoryHash());
            }
        }
        return hashes;
    }

    /** A room with a desk and a visitor, noisy sensors, and faults that come and go, for the wall follower. */
    private static SimulationSetup busyRoom(long seed) {
        RobotSpec robot = RobotSpec.DEFAULT;
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(new SensorSpec(
                    sensor.id(), sensor.mountPosition(), sensor.bearing(), sensor.range(), sensor.cone(), true, 0.002));
        }
        WaypointPath walk = new WaypointPath(0.2, true, List.of(new Vector2(2.5, 2.2), new Vector2(2.5, 1.4)));
        WorldSpec world = new WorldSpec(
                4,
                3,
                true,
                3,
                List.of(
                        new Obstacle("desk", new ObstacleShape.RectangleShape(0.6, 0.4), new Pose(2, 1.5, 0.4)),
                        new Obstacle("visitor", new ObstacleShape.CircleShape(0.15), new Pose(2.5, 2.2, 0), walk)));
        List<SimulationSetup.TimedCommand> timeline = List.of(
                new SimulationSetup.TimedCommand(5, new Command.InjectFault("left", new Fault.Dropout(0.1))),
                new SimulationSetup.TimedCommand(10, new Command.ClearFaults("left")),
                new SimulationSetup.TimedCommand(12, new Command.SwitchSensor("rear", false)));
        return SimulationSetup.of(world, new Pose(0.6, 0.6, 0.3))
                .withRobot(robot)
                .withTimeline(timeline)
                .withSeed(seed)
                .withDuration(60);
    }
}
