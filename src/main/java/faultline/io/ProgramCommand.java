package faultline.io;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.UnaryOperator;

/** The command that starts this program, for commands that are shown to users. */
public final class ProgramCommand {

    /** Set by the launcher of an installed package: the name of its command. */
    private static final String COMMAND = "faultline.command";
    /** Set by the launcher that jpackage makes: its path. An app image may be in any folder. */
    private static final String LAUNCHER = "jpackage.app-path";

    private static final String BUILT_JAR = "java -jar target/faultline.jar";

    private ProgramCommand() {}

    /**
     * {@return the command of an installed package, the launcher or the jar that this program was started by, or else
     * the command of the jar that a build makes}
     */
    public static String text() {
        String searched = System.getenv("PATH");
        return text(
                System::getProperty,
                searched == null ? "" : searched,
                ProgramFile.find().orElse(Path.of("")));
    }

    /**
     * Returns the command, given the system properties, the folders that are searched for programs, and the jar or
     * folder of this program, an empty path if it is not known.
     */
    static String text(UnaryOperator<String> properties, String searched, Path source) {
        String command = properties.apply(COMMAND);
        String launcher = properties.apply(LAUNCHER);
        if (command != null) {
            return launcher == null || isFound(Path.of(launcher), searched) ? command : ShellText.quoted(launcher);
        }
        // For java -jar, the class path is the path of the jar as the user has written it.
        String jar = properties.apply("java.class.path");
        return jar != null && Files.isRegularFile(source) && isSame(jar, source)
                ? "java -jar " + ShellText.quoted(jar)
                : BUILT_JAR;
    }

    /** Returns whether the name of a launcher starts it. */
    private static boolean isFound(Path launcher, String searched) {
        for (String folder : searched.split(File.pathSeparator)) {
            String file = folder + File.separator + launcher.getFileName();
            if (!folder.isEmpty() && new File(file).canExecute()) {
                return isSame(file, launcher);
            }
        }
        return false;
    }

    private static boolean isSame(String file, Path other) {
        try {
            return Files.isSameFile(Path.of(file), other);
        } catch (IOException | InvalidPathException e) {
            return false;
        }
    }
}
