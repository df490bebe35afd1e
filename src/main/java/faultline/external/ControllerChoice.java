package faultline.external;

import faultline.control.ControllerProvider;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerProviders;
import faultline.engine.SimulationSetup;
import faultline.io.ProgramVersion;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/**
 * The choice of a controller by a user: a built-in one, the name of a controller in Java, a command that starts a child
 * process, or the scenario's own controller. What searches the jars runs their code, which may take any time.
 *
 * @param text the name or the command; empty for the scenario's own controller
 * @param jars the jar files that are searched for controllers in Java, besides the class path
 */
public record ControllerChoice(String text, List<Path> jars) {

    /** The controller that the scenario names. */
    public static final ControllerChoice SCENARIO = of("");

    /**
     * Creates a choice from a copy of the jars.
     *
     * @param text the name or the command; empty for the scenario's own controller
     * @param jars the jar files that are searched for controllers in Java, besides the class path
     */
    public ControllerChoice {
        Objects.requireNonNull(text, "text");
        jars = List.copyOf(jars);
    }

    /**
     * {@return a choice without jars}
     *
     * @param text the name or the command; empty for the scenario's own controller
     */
    public static ControllerChoice of(String text) {
        return new ControllerChoice(text, List.of());
    }

    /** {@return whether this is the scenario's own controller} */
    public boolean isScenarioDefault() {
        return text.isEmpty();
    }

    /** {@return whether this is a controller of the program} */
    public boolean isBuiltIn() {
        return text.equals(ControllerNames.WALL_FOLLOWER) || text.equals(ControllerNames.NONE);
    }

    /** {@return whether this is a command that starts a child process} This searches the jars. */
    public boolean isCommand() {
        return !isScenarioDefault() && !isInJars() && !ControllerNames.all().contains(text);
    }

    /**
     * {@return whether a run starts a child process, because a command was chosen for it} This searches nothing.
     *
     * @param setup the setup of the run, as a choice has returned it
     */
    public static boolean startsCommand(SimulationSetup setup) {
        return setup.controller() instanceof ControllerSpec.Chosen chosen
                && chosen.source() instanceof ProcessControllerSource;
    }

    private boolean isInJars() {
        return !jars.isEmpty()
                && ControllerJars.callWith(
                        jars, () -> ControllerProviders.find(text).isPresent());
    }

    /**
     * {@return a setup with this controller} This searches the jars. A run loads its controller from them as they are
     * when it starts; they may be replaced during the run.
     *
     * @param setup the setup with the scenario's own controller
     * @param commands the source of the controller if this is a command
     */
    public SimulationSetup applyTo(SimulationSetup setup, ControllerSource commands) {
        if (isScenarioDefault()) {
            return setup;
        }
        ControllerSpec original = setup.controller();
        if (isInJars()) {
            return setup.withController(
                    new ControllerSpec.Chosen(original, new JarControllerSource(text, jars, settingsIn(original))));
        }
        if (isBuiltIn()) {
            return applyByName(setup);
        }
        Optional<ControllerProvider> provider = ControllerProviders.find(text);
        ControllerSource source =
                provider.isPresent() ? new JavaControllerSource(text, provider.get(), settingsIn(original)) : commands;
        return setup.withController(new ControllerSpec.Chosen(original, source));
    }

    /**
     * {@return a setup with this controller} A child process has the default time limits and gets no ground truth. This
     * searches the jars as {@link #applyTo(SimulationSetup, ControllerSource)} does.
     *
     * @param setup the setup with the scenario's own controller
     * @param scenarioName the name of the scenario for a child process
     * @param errors the consumer of each line of a child's standard error, called on a separate thread
     */
    public SimulationSetup applyTo(SimulationSetup setup, String scenarioName, Consumer<String> errors) {
        ProcessControllerSource.ChildSettings settings = new ProcessControllerSource.ChildSettings(
                ProgramVersion.text(), scenarioName, ExternalController.Timeouts.DEFAULT, false, errors);
        return applyTo(setup, new ProcessControllerSource(text, settings));
    }

    /**
     * {@return a setup whose scenario file names this controller} It is no command, which no file can name. It need not
     * be available.
     *
     * @param setup the setup with the scenario's own controller; it keeps its period and its wanted distance, and its
     *     settings if it has the same name
     */
    public SimulationSetup applyByName(SimulationSetup setup) {
        ControllerSpec original = setup.controller();
        if (isScenarioDefault()) {
            return setup;
        }
        if (text.equals(ControllerNames.WALL_FOLLOWER)) {
            return original instanceof ControllerSpec.WallFollowing
                    ? setup
                    : setup.withController(ControllerSpec.WallFollowing.DEFAULT);
        }
        return setup.withController(
                text.equals(ControllerNames.NONE)
                        ? new ControllerSpec.None()
                        : new ControllerSpec.Provided(
                                text,
                                original.period(),
                                original.wantedDistance().orElse(ControllerSpec.WallFollowing.DEFAULT.distance()),
                                settingsIn(original)));
    }

    private Map<String, String> settingsIn(ControllerSpec original) {
        return original instanceof ControllerSpec.Provided given && given.name().equals(text)
                ? given.settings()
                : Map.of();
    }

    /**
     * {@return the result of work that can use the controllers of the jars, as can the threads that it starts} This
     * loads the jars.
     *
     * @param <T> the type of the result
     * @param work the work, which is called on the calling thread
     * @throws Exception if the work throws it
     */
    public <T> T callWithJars(Callable<T> work) throws Exception {
        // Without jars, those of the command line are available.
        return jars.isEmpty() ? work.call() : ControllerJars.callWith(jars, work::call);
    }

    /** {@return the jars, and then the files that the words of a command name, such as the program and its script} */
    public List<Path> files() {
        List<Path> files = new ArrayList<>(jars);
        try {
            ShellWords.split(text).forEach(word -> addFile(word, files));
        } catch (IllegalArgumentException unfinished) {
            // The command has a quote without an end, and no words.
        }
        return files;
    }

    private static void addFile(String word, List<Path> files) {
        try {
            Path file = Path.of(word);
            if (Files.isRegularFile(file)) {
                files.add(file);
            }
        } catch (InvalidPathException noPath) {
            // A word that is not a path does not name a file.
        }
    }
}
