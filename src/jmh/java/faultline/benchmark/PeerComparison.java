package faultline.benchmark;

import com.sun.management.OperatingSystemMXBean;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.sensor.SensorSpec;
import faultline.world.ObstacleShape;
import faultline.world.World;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.StringJoiner;

/**
 * The part of {@code src/conf/compare-peers} that measures this program, in the same way as the programs under
 * {@code src/peers} measure others. A room is given by its number of segments, or is {@code posts}. Arguments:
 *
 * <ul>
 *   <li>{@code rooms FOLDER ROOM...} writes each room to a file for the peers.
 *   <li>{@code times SECONDS ROOM...} prints a line {@code time MICROSECONDS} for each room.
 *   <li>{@code readings ROOM} prints a line {@code rays DISTANCE...} for each pose of the room's file.
 * </ul>
 */
public final class PeerComparison {

    /** The side of a post, metres. */
    private static final double POST = 0.02;

    private PeerComparison() {}

    /**
     * Writes rooms, or measures.
     *
     * @param args what to do, and with what
     * @throws IOException if a room cannot be written
     */
    public static void main(String[] args) throws IOException {
        switch (args[0]) {
            case "rooms" -> {
                for (int i = 2; i < args.length; i++) {
                    Files.writeString(Path.of(args[1], args[i]), new PeerRoom(setup(args[i])).text());
                }
            }
            case "times" -> {
                for (int i = 2; i < args.length; i++) {
                    System.out.println("time " + tickTime(setup(args[i]), Double.parseDouble(args[1])));
                }
            }
            default -> printReadings(setup(args[1]));
        }
    }

    private static SimulationSetup setup(String room) {
        return room.equals("posts") ? posts(BenchmarkRooms.of(400)) : BenchmarkRooms.of(Integer.parseInt(room));
    }

    /** Returns a room with a thin post in place of each rectangle. */
    private static SimulationSetup posts(SimulationSetup setup) {
        ObstacleShape post = new ObstacleShape.RectangleShape(POST, POST);
        return setup.withWorld(setup.world()
                .withObstacles(setup.world().obstacles().stream()
                        .map(obstacle -> obstacle.withShape(post))
                        .toList()));
    }

    /**
     * Returns the processor time of a tick, microseconds, with all threads of the virtual machine. The number of ticks
     * is doubled until they take long enough, so that all but the last ones only warm up.
     */
    private static double tickTime(SimulationSetup setup, double seconds) {
        OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        simulation.stopRecordingPath();
        for (long ticks = 1; ; ticks *= 2) {
            long begin = system.getProcessCpuTime();
            for (long i = 0; i < ticks; i++) {
                simulation.tick();
            }
            double time = (system.getProcessCpuTime() - begin) / 1e9;
            if (time >= seconds) {
                return time / ticks * 1e6;
            }
        }
    }

    private static void printReadings(SimulationSetup setup) {
        for (Pose pose : new PeerRoom(setup).poses()) {
            World world = new World(setup.world(), setup.robot(), pose, setup.dt(), setup.seed());
            world.sense();
            StringJoiner line = new StringJoiner(" ", "rays ", "");
            for (int i = 0; i < setup.robot().sensors().size(); i++) {
                SensorSpec sensor = setup.robot().sensors().get(i);
                line.add(String.format(Locale.ROOT, "%.9f", Math.min(sensor.range(), world.trueReading(i))));
            }
            System.out.println(line);
        }
    }
}
