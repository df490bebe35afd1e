package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.util.Map;
import java.util.function.Consumer;

/** Starts a child process for each run. */
public final class ChildSource implements ControllerSource, TickObserver, AutoCloseable {

    private final String command;
    private final Terms terms;
    private ExternalController newest;
    private boolean keepsOpen;

    /**
     * What all children of a command have in common.
     *
     * @param program the name and version of the simulator
     * @param scenario the name of the scenario
     * @param timeouts how long a child is waited for
     * @param givesTruth whether observations carry the ground truth; this source must then observe the run
     * @param errors receives each line of a child's standard error, on a thread of its own
     */
    public record Terms(
            String program,
            String scenario,
            ExternalController.Timeouts timeouts,
            boolean givesTruth,
            Consumer<String> errors) {}

    /**
     * Creates a source that starts a command.
     *
     * @param command the command, as in a shell
     * @param terms what all of its children have in common
     */
    public ChildSource(String command, Terms terms) {
        this.command = command;
        this.terms = terms;
    }

    /**
     * {@return this source, which leaves a child open at the end of its run until it is closed, so that the child can
     * be sent a result}
     */
    public ChildSource keepOpen() {
        keepsOpen = true;
        return this;
    }

    /**
     * Starts a child and waits until it is ready.
     *
     * @throws RunFailedException if it cannot be started or does not become ready, in one sentence
     */
    @Override
    public Controller start(RunConditions run) {
        RunDescription description = new RunDescription(
                terms.program(),
                terms.scenario(),
                run.seed(),
                run.dt(),
                run.periodTicks(),
                run.duration(),
                run.robot());
        newest = new ExternalController(command, description, terms.timeouts(), terms.givesTruth(), terms.errors());
        return keepsOpen ? newest::decide : newest;
    }

    @Override
    public boolean limitsAnswerTime() {
        return true;
    }

    /**
     * Sends the newest child the result of its run.
     *
     * @param trajectoryHash of the whole run
     * @param summary the lines of the run's summary
     */
    public void finish(String trajectoryHash, Map<String, String> summary) {
        newest.finish("duration", trajectoryHash, summary);
    }

    /** Ends the newest child if it was kept open. */
    @Override
    public void close() {
        if (newest != null) {
            newest.close();
        }
    }

    /** Gives the newest child the truth with the coming observation, if it is wanted. */
    @Override
    public void observe(Simulation simulation) {
        newest.observe(simulation);
    }
}
