package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import java.util.Map;
import java.util.function.Consumer;

/** Starts a child process for each run. */
public final class ProcessControllerSource implements ControllerSource, TickObserver, AutoCloseable {

    private final String command;
    private final ChildSettings settings;
    private ExternalController newest;
    private boolean keepsOpen;

    /**
     * The properties that all children of a command have in common.
     *
     * @param program the name and version of the simulator
     * @param scenario the name of the scenario
     * @param timeouts the time limits for a child
     * @param givesTruth whether observations carry the ground truth; this source must then observe the run
     * @param errors the consumer of each line of a child's standard error, called on a separate thread
     */
    public record ChildSettings(
            String program,
            String scenario,
            ExternalController.Timeouts timeouts,
            boolean givesTruth,
            Consumer<String> errors) {}

    /**
     * Creates a source that starts a command.
     *
     * @param command the command, as in a shell
     * @param settings the properties of all of its children
     */
    public ProcessControllerSource(String command, ChildSettings settings) {
        this.command = command;
        this.settings = settings;
    }

    /**
     * {@return this source, which from then on keeps a child open at the end of its run, so that a result can be sent
     * to it}
     */
    public ProcessControllerSource keepOpen() {
        keepsOpen = true;
        return this;
    }

    /**
     * Starts a child and waits until it is ready.
     *
     * @throws RunFailedException if it cannot be started or does not become ready
     */
    @Override
    public Controller start(RunConditions run) {
        RunDescription description = new RunDescription(settings.program(), settings.scenario(), run);
        newest = new ExternalController(
                command, description, settings.timeouts(), settings.givesTruth(), settings.errors());
        return keepsOpen ? newest::decide : newest;
    }

    @Override
    public boolean limitsAnswerTime() {
        return true;
    }

    /**
     * Sends the result of its run to the latest child, and ends it.
     *
     * @param trajectoryHash the trajectory hash of the whole run
     * @param summary the lines of the run's summary
     * @throws RunFailedException if the child has answered more often than it was asked
     */
    public void finish(String trajectoryHash, Map<String, String> summary) {
        newest.finish("duration", trajectoryHash, summary);
    }

    /** Ends the latest child if it was kept open. */
    @Override
    public void close() {
        if (newest != null) {
            newest.close();
        }
    }

    /** Sends the truth to the latest child with the next observation, if this is enabled. */
    @Override
    public void observe(Simulation simulation) {
        newest.observe(simulation);
    }
}
