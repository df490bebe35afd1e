package faultline.gui.document;

import java.util.regex.Pattern;

/** Makes a file's name of a scenario's, which may hold any letters; the name is one that every system takes. */
public final class FileNames {

    private static final String DEFAULT_NAME = "scenario";
    private static final int MAX_LENGTH = 100;
    /** Windows has devices of these names in every folder, with any extension. */
    private static final Pattern DEVICE_NAME = Pattern.compile("(?i)(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?");

    private FileNames() {}

    /**
     * The name of a file.
     *
     * @param scenario the name of a scenario, may be empty
     * @return without extension, never empty
     */
    public static String forScenario(String scenario) {
        String letters = scenario.replaceAll("[^\\p{L}\\p{N} ._-]", "_");
        String name = letters.substring(
                        0,
                        letters.offsetByCodePoints(
                                0, Math.min(MAX_LENGTH, letters.codePointCount(0, letters.length()))))
                .replaceAll("^[ .]+|[ .]+$", "");
        return name.isEmpty() ? DEFAULT_NAME : DEVICE_NAME.matcher(name).matches() ? "_" + name : name;
    }
}
