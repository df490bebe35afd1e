package faultline.external;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerProviders;
import faultline.io.ShellText;
import faultline.scenario.xml.Allowed;
import java.io.File;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** The names that choose controllers, and those of their types in scenario files. */
public final class ControllerNames {

    /** The name of the built-in wall follower, which uses the settings of the scenario if it has any. */
    public static final String WALL_FOLLOWER = ControllerSpec.WallFollowing.TYPE;

    /** The name of the controller with which the robot stands still. */
    public static final String NONE = ControllerSpec.None.TYPE;

    private ControllerNames() {}

    /** {@return the names that are not commands: those of the program and of the class path} */
    public static List<String> all() {
        return all(ControllerProviders.names());
    }

    /**
     * {@return the names of the program's controllers and others}
     *
     * @param others the names of controllers of the class path or of jars
     */
    public static List<String> all(Collection<String> others) {
        List<String> names = new ArrayList<>(List.of(WALL_FOLLOWER, NONE));
        names.addAll(others);
        return names;
    }

    /**
     * {@return the type of a controller in a scenario file}
     *
     * @param spec the choice of the controller
     */
    public static String typeOf(ControllerSpec spec) {
        return spec.match(new ControllerSpec.ControllerCases<>(
                builtIn -> builtIn.matchBuiltIn(new ControllerSpec.BuiltInCases<>(
                        none -> ControllerSpec.None.TYPE,
                        drive -> ControllerSpec.Drive.TYPE,
                        follower -> ControllerSpec.WallFollowing.TYPE)),
                extern -> ControllerSpec.Extern.TYPE,
                ControllerSpec.Provided::name,
                chosen -> typeOf(chosen.original()),
                recorded -> ControllerSpec.Recorded.TYPE));
    }

    /**
     * Returns a hint for a command of one word that is not the name of a program, such as a misspelt name, and for an
     * unquoted path with blanks; empty for another path.
     */
    static Object hint(String command) {
        String word = command.strip();
        if (word.contains(" ") && new File(word).isFile()) {
            return ControllerProblem.UNQUOTED.with(ShellText.quoted(word));
        }
        List<String> names = all();
        return word.contains(" ") || word.contains("/") || word.contains("\\")
                ? ""
                : Allowed.withHint(ControllerProblem.NAMES.with(Allowed.names(names)), word, names);
    }
}
