package faultline.engine.session;

import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RunFailedException;
import faultline.engine.RunProblem;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunMeter;
import faultline.engine.recording.Recorder;
import faultline.io.Message;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Refusal;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.LongPredicate;

/**
 * A simulation that is recorded, measured and paced, that runs or is paused, and that executes commands between ticks.
 * A tick that fails is the last one. Only one thread at a time may use it.
 */
final class InteractiveRun implements AutoCloseable {

    private static final long NO_PAUSE_TICK = -1;

    private final Simulation simulation;
    private final Recorder recorder;
    private final RunMeter meter;
    private final JournalPlayer player;
    private final Pacer pacer = new Pacer();
    private boolean running;
    private long pauseTick = NO_PAUSE_TICK;
    private boolean frameOutdated;
    private int refusals;
    private Refusal lastRefusal;
    private Message failure;

    /** Creates a run with the setup and the commands of an earlier one, paused at tick 0. */
    InteractiveRun(Journal journal) {
        recorder = new Recorder(journal.setup());
        meter = new RunMeter(journal.setup());
        player = new JournalPlayer(journal);
        simulation = new Simulation(journal.setup(), ControllerMode.OWN_THREAD, recorder);
        try {
            recorder.observe(simulation);
            meter.observe(simulation);
        } catch (RuntimeException | Error e) {
            simulation.close();
            throw e;
        }
    }

    /** Makes all ticks up to one at full speed; after each of them, the condition may cancel the replay. */
    void replayTo(long tick, LongPredicate shouldContinue) {
        while (simulation.ticks() < tick) {
            advance();
            if (!shouldContinue.test(simulation.ticks())) {
                throw new CancellationException("the replay was cancelled at tick " + simulation.ticks());
            }
        }
    }

    /** Executes the timeline's commands for the next tick, which it does not execute again. */
    void executeDueCommands() {
        simulation.executeDueCommands();
    }

    /** Executes the earlier run's commands for the next tick. */
    void executeNextCommands() {
        player.executeCommands(simulation);
        simulation.resample();
    }

    /** Executes commands from outside; unless all are refused, the run no longer follows the earlier one. */
    List<CommandResult> execute(List<Command> commands) {
        return commands.stream().map(this::execute).toList();
    }

    private CommandResult execute(Command command) {
        CommandResult result = JournalPlayer.execute(simulation, command);
        if (result.refusal().isPresent()) {
            refusals++;
            lastRefusal = result.refusal().get();
        } else {
            player.discardPending();
        }
        frameOutdated = true;
        return result;
    }

    boolean isRunning() {
        return running;
    }

    void setRunning(boolean wanted) {
        running = wanted && failure == null;
        pacer.restart();
    }

    /** Pauses the run once, at the end of a later tick. */
    void pauseAt(long tick) {
        pauseTick = tick;
    }

    /** Sets the speed as a multiple of real time, positive. */
    void setSpeed(double factor) {
        pacer.setSpeed(factor);
    }

    /** Pauses the run and makes one tick, unless the run has failed. */
    void step() {
        running = false;
        if (failure == null) {
            tick();
        }
    }

    /** Makes one tick. */
    void tick() {
        try {
            advance();
            pacer.tickCompleted(simulation.setup().dt());
            frameOutdated = true;
            running = running && simulation.ticks() != pauseTick;
        } catch (RuntimeException e) {
            fail(e);
        }
    }

    private void advance() {
        player.tick(simulation);
        recorder.observe(simulation);
        meter.observe(simulation);
    }

    /** Ends the run because of an exception or error. */
    void fail(Throwable cause) {
        running = false;
        failure = cause instanceof RunFailedException failed
                ? failed.reason()
                : RunProblem.RUN_BROKE.with(simulation.ticks(), cause.toString());
    }

    /** Waits until the next tick is due or the thread is unparked. */
    void awaitTick() {
        pacer.awaitTick();
    }

    /** Returns whether something that a frame shows has changed since the last frame. */
    boolean isFrameOutdated() {
        return frameOutdated;
    }

    /** Returns a frame; in a paused run it shows readings after the last commands. */
    SessionFrame frame() {
        if (frameOutdated && !running) {
            simulation.resample();
        }
        frameOutdated = false;
        return new SessionFrame(
                simulation.frame(),
                recorder.view(),
                meter.measures(),
                simulation.controllerSpec(),
                simulation.controllerName(),
                simulation.setup().dt());
    }

    SessionStatus status() {
        return new SessionStatus(
                running, pacer.speed(), running ? pacer.achievedSpeed() : 0, refusals, lastRefusal, failure);
    }

    SimulationSetup setup() {
        return simulation.setup();
    }

    /** Returns the commands executed so far. */
    Journal journal() {
        return simulation.journal();
    }

    /** Returns the commands executed so far and those of the earlier run that are still to be executed. */
    Journal fullJournal() {
        return player.fullJournal(simulation);
    }

    @Override
    public void close() {
        simulation.close();
    }
}
