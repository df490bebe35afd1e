package faultline.benchmark;

import com.sun.management.ThreadMXBean;
import faultline.campaign.RandomRoom;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.world.World;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;

/**
 * Prints the processor time and the allocation of a tick, medians of short passes, all in one process. Unlike elapsed
 * time, it says something on a machine that other work shares.
 */
public final class ProcessorTime {

    private static final int PASSES = 8;
    private static final int SHORT_PASSES = 41;
    private static final int WARM_UP = 20;
    /** Of a short pass. */
    private static final int TICKS = 20_000;

    private static final int[] SEGMENTS = {4, 40, 400, 4000, 40_000};
    private static final int ROOMS = 20;
    private static final int ROOM_TICKS = 12_000;
    private static final long FIRST_ROOM = 770_000;
    private static final int CHECKED_TICKS = 10_000;
    /** Metres. */
    private static final double PROBE_TOLERANCE = 1e-9;

    private static final int INDEXED_SEGMENTS = 100_000;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private ProcessorTime() {}

    /** Prints the table; the first pass only warms up. */
    public static void main(String[] args) {
        printFollower();
        for (int segments : SEGMENTS) {
            SimulationSetup setup = BenchmarkRooms.of(segments);
            checkProbe(setup);
            Action probe = new Action(segments + " segments, bare probe", new BareProbe(setup));
            Simulation run = run(setup);
            Action tick = new Action(segments + " segments", run::tick);
            Action alone = new Action(segments + " segments, the world alone", worldAlone(setup));
            print(TICKS, probe, tick, alone);
            BenchmarkRooms.close(run);
            System.out.println(String.format(
                    Locale.ROOT, "%-40s %10.2f", segments + " segments, tick : probe", tick.time() / probe.time()));
        }
        for (RoomVariant room : RoomVariant.values()) {
            int ticks = room == RoomVariant.MOVERS_1000 ? TICKS / 40 : TICKS / 4;
            Simulation run = run(room.setup());
            print(ticks, new Action(room.toString(), run::tick));
            BenchmarkRooms.close(run);
        }
        SimulationSetup large = BenchmarkRooms.of(INDEXED_SEGMENTS);
        print(1, new Action(INDEXED_SEGMENTS + " segments, made", () -> makeWorld(large)));
    }

    /** Returns a run of which no one shows a frame. */
    private static Simulation run(SimulationSetup setup) {
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        simulation.stopRecordingPath();
        return simulation;
    }

    /** Prints the mean over random rooms of the least time of a tick in each, without and with diagnosis in turn. */
    private static void printFollower() {
        double without = 0;
        double with = 0;
        for (int room = -PASSES; room < ROOMS; room++) {
            double leastWithout = Double.POSITIVE_INFINITY;
            double leastWith = Double.POSITIVE_INFINITY;
            for (int pass = 0; pass < PASSES; pass++) {
                leastWithout = Math.min(leastWithout, follow(Math.max(0, room), false));
                leastWith = Math.min(leastWith, follow(Math.max(0, room), true));
            }
            // The first rooms only warm up.
            without += room < 0 ? 0 : leastWithout / ROOMS;
            with += room < 0 ? 0 : leastWith / ROOMS;
        }
        System.out.println(String.format(
                Locale.ROOT, "%-40s %10.3f us, with diagnosis %.3f us", ROOMS + " rooms, follower", without, with));
    }

    /** Returns the time of a tick in a random room, microseconds. */
    private static double follow(int number, boolean diagnosis) {
        RandomRoom room = RandomRoom.ofSeed(FIRST_ROOM + number);
        Simulation simulation = run(SimulationSetup.of(room.world(), room.start())
                .withController(ControllerSpec.WallFollowing.DEFAULT.withDiagnosis(diagnosis)));
        long time = THREADS.getCurrentThreadCpuTime();
        for (int tick = 0; tick < ROOM_TICKS; tick++) {
            simulation.tick();
        }
        long end = THREADS.getCurrentThreadCpuTime();
        BenchmarkRooms.close(simulation);
        return (end - time) / 1e3 / ROOM_TICKS;
    }

    private static World makeWorld(SimulationSetup setup) {
        return new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
    }

    private static Runnable worldAlone(SimulationSetup setup) {
        World world = makeWorld(setup);
        ControllerSpec.Drive circle = (ControllerSpec.Drive) setup.controller();
        return () -> {
            world.move(circle.leftVolts(), circle.rightVolts());
            world.sense();
        };
    }

    /** Fails if the probe and the world do not measure the same; then the probe's time would say nothing. */
    private static void checkProbe(SimulationSetup setup) {
        World world = makeWorld(setup);
        ControllerSpec.Drive circle = (ControllerSpec.Drive) setup.controller();
        BareProbe probe = new BareProbe(setup);
        for (int tick = 0; tick < CHECKED_TICKS; tick++) {
            probe.run();
            world.move(circle.leftVolts(), circle.rightVolts());
            world.sense();
            for (int i = 0; i < setup.robot().sensors().size(); i++) {
                double off = Math.abs(probe.reading(i) - world.trueReading(i));
                if (off > PROBE_TOLERANCE || (Double.isNaN(off) && probe.reading(i) != world.trueReading(i))) {
                    throw new IllegalStateException(
                            "sensor " + i + ": " + probe.reading(i) + ", not " + world.trueReading(i));
                }
            }
        }
    }

    /** Measures actions in turn, so that all are disturbed alike, and prints the medians. */
    private static void print(int count, Action... actions) {
        for (int pass = -WARM_UP; pass < SHORT_PASSES; pass++) {
            for (Action action : actions) {
                action.measure(count, pass);
            }
        }
        for (Action action : actions) {
            System.out.println(
                    String.format(Locale.ROOT, "%-40s %10.3f us %8.1f B", action.name, action.time(), action.bytes()));
        }
    }

    /** Something that is measured in many short passes. */
    private static final class Action {
        private final String name;
        private final Runnable body;
        /** Microseconds. */
        private final double[] times = new double[SHORT_PASSES];

        private final double[] bytes = new double[SHORT_PASSES];

        Action(String name, Runnable body) {
            this.name = name;
            this.body = body;
        }

        /** Makes a pass; those of negative numbers only warm up. */
        void measure(int count, int pass) {
            long time = THREADS.getCurrentThreadCpuTime();
            long allocated = THREADS.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < count; i++) {
                body.run();
            }
            int kept = Math.max(0, pass);
            times[kept] = (THREADS.getCurrentThreadCpuTime() - time) / 1e3 / count;
            bytes[kept] = (double) (THREADS.getCurrentThreadAllocatedBytes() - allocated) / count;
        }

        double time() {
            return median(times);
        }

        double bytes() {
            return median(bytes);
        }

        private static double median(double[] values) {
            double[] sorted = values.clone();
            Arrays.sort(sorted);
            return sorted[sorted.length / 2];
        }
    }
}
