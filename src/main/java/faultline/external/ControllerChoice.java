package faultline.external;

import faultline.control.ControllerProvider;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.engine.ControllerProviders;
import faultline.engine.SimulationSetup;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The choice of a controller by a user: a built-in one, the name of a controller in Java, or a command. */
public final class ControllerChoice {

    private ControllerChoice() {}

    /**
     * {@return whether a choice is a command that starts a child process}
     *
     * @param choice the value of an option or a field
     */
    public static boolean isCommand(String choice) {
        return !ControllerNames.all().contains(choice);
    }

    /**
     * {@return whether a choice is a command that starts a child process, also if some jars are searched}
     *
     * @param choice the value of an option or a field
     * @param jars the jar files
     */
    public static boolean isCommand(String choice, List<Path> jars) {
        return !isInJars(choice, jars) && isCommand(choice);
    }

    private static boolean isInJars(String choice, List<Path> jars) {
        return !jars.isEmpty()
                && ControllerJars.callWith(
                        jars, () -> ControllerProviders.find(choice).isPresent());
    }

    /**
     * {@return a setup with a chosen controller}
     *
     * @param choice a name or a command
     * @param setup the setup with another controller
     * @param commands the function that makes the source for a command
     */
    public static SimulationSetup withChosenController(
            String choice, SimulationSetup setup, ControllerSource commands) {
        ControllerSpec original = setup.controller();
        if (isBuiltIn(choice)) {
            return withControllerNamed(choice, setup);
        }
        Optional<ControllerProvider> provider = ControllerProviders.find(choice);
        if (provider.isEmpty()) {
            return setup.withController(new ControllerSpec.Chosen(original, commands));
        }
        return setup.withController(new ControllerSpec.Chosen(
                original, new JavaControllerSource(choice, provider.get(), settings(choice, original))));
    }

    /**
     * {@return a setup with a chosen controller, for which some jars are searched too} A run loads its controller from
     * the jars as they are when it starts; they may be replaced during the run.
     *
     * @param choice a name or a command
     * @param jars the jar files
     * @param setup the setup with another controller
     * @param commands the function that makes the source for a command
     */
    public static SimulationSetup withChosenController(
            String choice, List<Path> jars, SimulationSetup setup, ControllerSource commands) {
        ControllerSpec original = setup.controller();
        return isInJars(choice, jars)
                ? setup.withController(new ControllerSpec.Chosen(
                        original, new JarControllerSource(choice, jars, settings(choice, original))))
                : withChosenController(choice, setup, commands);
    }

    /**
     * {@return a setup with a chosen controller as a scenario file names it} The choice is no command, which no file
     * can name. It need not be available.
     *
     * @param choice a name
     * @param setup the setup with another controller; it keeps its period, and its settings if it has the same name
     */
    public static SimulationSetup withControllerNamed(String choice, SimulationSetup setup) {
        ControllerSpec original = setup.controller();
        if (choice.equals(ControllerNames.WALL_FOLLOWER)) {
            return original instanceof ControllerSpec.WallFollowing
                    ? setup
                    : setup.withController(ControllerSpec.WallFollowing.DEFAULT);
        }
        return setup.withController(
                choice.equals(ControllerNames.NONE)
                        ? new ControllerSpec.None()
                        : new ControllerSpec.Provided(choice, original.period(), settings(choice, original)));
    }

    /**
     * {@return whether a choice is a controller of the program}
     *
     * @param choice a name or a command
     */
    public static boolean isBuiltIn(String choice) {
        return choice.equals(ControllerNames.WALL_FOLLOWER) || choice.equals(ControllerNames.NONE);
    }

    private static Map<String, String> settings(String choice, ControllerSpec original) {
        return original instanceof ControllerSpec.Provided given && given.name().equals(choice)
                ? given.settings()
                : Map.of();
    }

    /**
     * {@return the files that the words of a command name, such as the program and its script}
     *
     * @param choice a name or a command
     */
    public static List<Path> files(String choice) {
        List<Path> files = new ArrayList<>();
        try {
            for (String word : ShellWords.split(choice)) {
                addFile(word, files);
            }
        } catch (IllegalArgumentException unfinished) {
            return List.of();
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
