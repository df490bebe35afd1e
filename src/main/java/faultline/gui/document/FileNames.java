package faultline.gui.document;

import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Derives file names from the names of scenarios. A file name is valid on every operating system, and in the encoding
 * that this system has for file names.
 */
public final class FileNames {

    /** The extensions of scenario files; a desktop opens files of the second with this program. */
    public static final List<String> SCENARIO_EXTENSIONS = List.of("xml", "faultline");

    /** Set by the launcher of a package that makes a desktop open files with an extension: that extension. */
    private static final String EXTENSION = "faultline.extension";

    private static final String DEFAULT_NAME = "scenario";
    private static final int MAX_LENGTH = 100;
    /** Many file systems allow 255 bytes, with the extension and what a program adds to it. */
    private static final int MAX_BYTES = 200;
    /** Windows reserves these names in every folder, with any extension. */
    private static final Pattern DEVICE_NAME = Pattern.compile("(?i)(con|prn|aux|nul|com[\\d¹²³]|lpt[\\d¹²³])(\\..*)?");

    private static final Pattern SCENARIO_EXTENSION =
            Pattern.compile("\\.(" + String.join("|", SCENARIO_EXTENSIONS) + ")$", Pattern.CASE_INSENSITIVE);

    private FileNames() {}

    /** Returns whether a file name ends with an extension of scenario files. */
    public static boolean hasScenarioExtension(String name) {
        return SCENARIO_EXTENSION.matcher(name).find();
    }

    /**
     * Returns the ending of the names of new scenario files: the one with which the desktop opens them if this program
     * is installed, or else ".xml".
     */
    public static String newScenarioEnding() {
        String first = SCENARIO_EXTENSIONS.get(0);
        String wanted = System.getProperty(EXTENSION, first);
        return "." + (SCENARIO_EXTENSIONS.contains(wanted) ? wanted : first);
    }

    /** Returns the name of a scenario file without its extension. */
    public static String withoutExtension(String name) {
        return SCENARIO_EXTENSION.matcher(name).replaceFirst("");
    }

    /** Returns the last name of a path, as messages show it; the whole path of a root folder, which has no name. */
    public static String lastOf(Path file) {
        return Objects.requireNonNullElse(file.getFileName(), file).toString();
    }

    /** Returns the file name, without an extension, for the name of a scenario, which may be empty. */
    public static String forScenario(String scenario) {
        return forScenario(scenario, FileNames::isPath);
    }

    /** Returns the file name, in which an underscore replaces each letter that is not allowed. */
    static String forScenario(String scenario, Predicate<String> isAllowed) {
        String name = start(scenario.replaceAll("[^\\p{L}\\p{M}\\p{N} ._-]", "_"))
                .codePoints()
                .mapToObj(Character::toString)
                .map(letter -> isAllowed.test(letter) ? letter : "_")
                .collect(Collectors.joining())
                .replaceAll("^[ .]+|[ .]+$", "");
        return name.isEmpty() ? DEFAULT_NAME : DEVICE_NAME.matcher(name).matches() ? "_" + name : name;
    }

    /** Returns whether a name can be that of a file. Without an encoding in the locale, only letters of ASCII can. */
    private static boolean isPath(String name) {
        try {
            return !Path.of(name).toString().isEmpty();
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /** Returns the start of a name that is short enough for a file. */
    private static String start(String name) {
        int end = 0;
        int bytes = 0;
        for (int letters = 0; letters < MAX_LENGTH && end < name.length(); letters++) {
            int next = name.offsetByCodePoints(end, 1);
            bytes += name.substring(end, next).getBytes(StandardCharsets.UTF_8).length;
            if (bytes > MAX_BYTES) {
                break;
            }
            end = next;
        }
        return name.substring(0, end);
    }
}
