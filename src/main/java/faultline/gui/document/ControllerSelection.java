package faultline.gui.document;

import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.external.ControllerJars;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.io.ProgramVersion;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * A controller that the user has chosen for runs of the window: a name or a command, empty for the scenario's own
 * controller, and the jar files with controllers in Java.
 */
public record ControllerSelection(String text, List<Path> jars) {

    /** The controller that the scenario names. */
    public static final ControllerSelection SCENARIO = new ControllerSelection("", List.of());

    public ControllerSelection {
        jars = List.copyOf(jars);
    }

    /** Returns whether this is the scenario's own controller. */
    public boolean isScenarios() {
        return text.isEmpty();
    }

    /**
     * Returns whether this starts a program. This searches the jars, so it is no work for the event dispatch thread.
     */
    public boolean startsProgram() {
        assert !EventQueue.isDispatchThread();
        return !isScenarios() && ControllerChoice.isCommand(text, jars);
    }

    /**
     * Returns a setup with this controller. A controller in another process gets the name of the scenario; each line
     * that it writes to standard error is passed on, on a separate thread. This searches the jars, whose code may take
     * any time, so it is no work for the event dispatch thread.
     */
    public SimulationSetup applyTo(SimulationSetup setup, String scenarioName, Consumer<String> errors) {
        assert !EventQueue.isDispatchThread();
        if (isScenarios()) {
            return setup;
        }
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                ProgramVersion.text(), scenarioName, ExternalController.Timeouts.DEFAULT, false, errors);
        return ControllerChoice.withChosenController(text, jars, setup, new ProcessControllerSource(text, settings));
    }

    /**
     * Returns the result of work that can use the controllers of the jars, as can the threads that it starts. This
     * loads the jars, so it is no work for the event dispatch thread.
     */
    public <T> T callWithJars(Callable<T> work) throws Exception {
        assert !EventQueue.isDispatchThread();
        // Without jars, those of the command line are available.
        return jars.isEmpty() ? work.call() : ControllerJars.callWith(jars, work::call);
    }

    /** Returns the files of the controller that the selection names. */
    public List<Path> files() {
        return Stream.concat(jars.stream(), ControllerChoice.files(text).stream())
                .toList();
    }
}
