package faultline.engine.session;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.recording.Recorder;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.concurrent.CancellationException;
import java.util.function.LongPredicate;

/**
 * A simulation with all that is remembered of it, and with what it replays of an earlier run. Used by the world thread.
 */
final class RecordedSimulation implements AutoCloseable {

    private final Simulation simulation;
    private final Recorder recorder;
    private final JournalPlayer player;

    private RecordedSimulation(Journal journal) {
        recorder = new Recorder(journal.setup());
        player = new JournalPlayer(journal);
        simulation = new Simulation(journal.setup(), ControllerMode.OWN_THREAD, recorder);
        recorder.observe(simulation);
    }

    /** The run of a journal at the end of a tick; takes as long as the run needs to come there, at full speed. */
    static RecordedSimulation replayTo(Journal journal, long tick, LongPredicate onward) {
        RecordedSimulation run = new RecordedSimulation(journal);
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
        player.tick(simulation);
        recorder.observe(simulation);
    }

    /** Carries out a command from outside; unless it is refused, this is a run of its own from now on. */
    CommandResult execute(Command command) {
        CommandResult result = simulation.execute(command);
        if (result.refusal().isEmpty()) {
            player.discardPending();
        }
        return result;
    }

    void resample() {
        simulation.resample();
    }

    SessionFrame frame() {
        return new SessionFrame(simulation.frame(), recorder.view());
    }

    Journal journal() {
        return simulation.journal();
    }

    Journal fullJournal() {
        return player.fullJournal(simulation);
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
