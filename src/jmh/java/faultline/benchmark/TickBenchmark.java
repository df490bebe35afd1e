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

/**
 * Whole ticks per second with eight sensors and the controller called directly, in rooms of more and more wall
 * segments.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class TickBenchmark {

    /** How many wall segments the room has. */
    @Param({"4", "400", "40000"})
    public int segments;

    private Simulation simulation;

    /** Makes the room. */
    @Setup(Level.Trial)
    public void open() {
        simulation = new Simulation(BenchmarkRooms.of(segments), ControllerMode.DIRECT);
    }

    /** Ends the run; a collided robot stands still, and its ticks would say nothing. */
    @TearDown(Level.Trial)
    public void close() {
        boolean collided = simulation.snapshot().collision().isPresent();
        simulation.close();
        if (collided) {
            throw new IllegalStateException("the robot collided: the figures are worthless");
        }
    }

    /** One tick. */
    @Benchmark
    public void tick() {
        simulation.tick();
    }
}
