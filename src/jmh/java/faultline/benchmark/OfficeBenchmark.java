package faultline.benchmark;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Ticks per second of the shipped office room, followed by the wall follower called directly: 100 ticks are one second,
 * so 200 000 are 2000 times real time.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class OfficeBenchmark {

    private static final int TICKS = 12_000;

    private SimulationSetup setup;
    private Simulation simulation;

    /**
     * Reads the room.
     *
     * @throws Exception if it cannot be read
     */
    @Setup(Level.Trial)
    public void open() throws Exception {
        setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
    }

    /** Two minutes of the room from its start, so that every run drives the same way. */
    @Benchmark
    @OperationsPerInvocation(TICKS)
    public void tick() {
        simulation = new Simulation(setup, ControllerMode.DIRECT);
        for (int i = 0; i < TICKS; i++) {
            simulation.tick();
        }
    }

    /** Ends the run. */
    @TearDown(Level.Trial)
    public void close() {
        BenchmarkRooms.close(simulation);
    }
}
