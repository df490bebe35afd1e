package faultline.engine;

import faultline.world.Command;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.LongPredicate;

/** A simulation with all that is remembered of it, and with what it replays of an earlier run. Used by the world thread. */
final class LiveRun implements AutoCloseable {

    private final Simulation simulation;
    private final Recorder recorder;
    private final Replay replay;

    private LiveRun(Journal journal) {
        recorder = new Recorder(journal.setup());
        replay = new Replay(journal);
        simulation = new Simulation(journal.setup(), ControllerMode.OWN_THREAD, recorder);
        recorder.observe(simulation);
    }

    /** The run of a journal at the end of a tick; takes as long as the run needs to come there, at full speed. */
    static LiveRun at(Journal journal, long tick, LongPredicate onward) {
        LiveRun run = new LiveRun(journal);
        try {
            while (run.simulation.ticks() < tick) {
                run.tick();
                if (!onward.test(run.ticks())) {
                    throw new CancellationException("given up at tick " + run.ticks());
                }
            }
            return run;
        } catch (RuntimeException broken) {
            run.close();
            throw broken;
        }
    }

    void tick() {
        replay.tick(simulation);
        recorder.observe(simulation);
    }

    /** Carries out a command from outside; unless it is refused, this is a run of its own from now on. */
    Optional<String> apply(Command command) {
        Optional<String> refusal = simulation.apply(command);
        if (refusal.isEmpty()) {
            replay.drop();
        }
        return refusal;
    }

    /** What would take a command back. */
    List<Command> undoing(Command command) {
        return simulation.undoing(command);
    }

    void look() {
        simulation.look();
    }

    Frame frame() {
        return simulation.frame().with(recorder.view());
    }

    Journal journal() {
        return simulation.journal();
    }

    Journal wholeJournal() {
        return replay.whole(simulation);
    }

    long ticks() {
        return simulation.ticks();
    }

    double dt() {
        return simulation.setup().dt();
    }

    @Override
    public void close() {
        simulation.close();
    }
}
