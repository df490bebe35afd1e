package faultline.benchmark;

import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.world.Command;
import faultline.world.World;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The time to make a world of 100 000 segments with its index, and to move one of its obstacles. */
@State(Scope.Thread)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class IndexBenchmark {

    private static final int SEGMENTS = 100_000;

    private SimulationSetup setup;
    private World world;
    private int next;

    /** Makes the setup, and the world that is edited. */
    @Setup(Level.Trial)
    public void open() {
        setup = BenchmarkRooms.of(SEGMENTS);
        world = make();
    }

    /** Makes a world. */
    @Benchmark
    @BenchmarkMode(Mode.SingleShotTime)
    @Warmup(iterations = 5)
    @Measurement(iterations = 10)
    public World make() {
        return new World(setup.world(), setup.robot(), setup.start(), setup.dt(), setup.seed());
    }

    /** Moves an obstacle to the place of the one before it, and reads the sensors. */
    @Benchmark
    @BenchmarkMode(Mode.AverageTime)
    public void edit() {
        int obstacles = setup.world().obstacles().size();
        next = (next + 1) % (obstacles - 1);
        Pose pose = setup.world().obstacles().get(next + 1).pose();
        world.execute(new Command.MoveObstacle("r" + next, pose));
        world.sense();
    }
}
