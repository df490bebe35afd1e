package faultline.benchmark;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.world.World;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The time of a whole tick with eight sensors in rooms of more and more wall segments, with the controller called
 * directly and on its own thread, beside that of the world alone.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class TickBenchmark {

    /** How many wall segments the room has. */
    @Param({"4", "40", "400", "4000", "40000"})
    public int segments;

    private Simulation simulation;
    private Simulation threaded;
    private World probe;
    private double leftVolts;
    private double rightVolts;

    /** Makes the room. */
    @Setup(Level.Trial)
    public void open() {
        SimulationSetup setup = BenchmarkRooms.of(segments);
        simulation = new Simulation(setup, ControllerMode.DIRECT);
        threaded = new Simulation(setup, ControllerMode.OWN_THREAD);
        probe = new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
        ControllerSpec.Drive circle = (ControllerSpec.Drive) setup.controller();
        leftVolts = circle.leftVolts();
        rightVolts = circle.rightVolts();
    }

    /** Ends the runs. */
    @TearDown(Level.Trial)
    public void close() {
        threaded.close();
        BenchmarkRooms.close(simulation);
    }

    /** One tick. */
    @Benchmark
    public void tick() {
        simulation.tick();
    }

    /** One tick whose decision is made on another thread. */
    @Benchmark
    public void tickOwnThread() {
        threaded.tick();
    }

    /** The world alone: motion, contact and eight cones, without controller, hash and path. */
    @Benchmark
    public void world() {
        probe.move(leftVolts, rightVolts);
        probe.sense();
    }
}
