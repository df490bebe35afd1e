package faultline.benchmark;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
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

/** The time of a whole tick in rooms of other shapes, sensors and movers. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class VariantBenchmark {

    /** The room. */
    @Param
    public RoomVariant room;

    private Simulation simulation;

    /** Makes the room. */
    @Setup(Level.Trial)
    public void open() {
        simulation = new Simulation(room.setup(), ControllerMode.DIRECT);
    }

    /** Ends the run. */
    @TearDown(Level.Trial)
    public void close() {
        BenchmarkRooms.close(simulation);
    }

    /** One tick. */
    @Benchmark
    public void tick() {
        simulation.tick();
    }
}
