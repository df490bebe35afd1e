package faultline.gui.document;

import java.util.regex.Pattern;

/** Makes a file's name of a scenario's, which may hold any letters; the name is one that every system takes. */
public final class FileName {

    private static final String NONE = "scenario";
    private static final int LONGEST = 100;
    /** Windows has devices of these names in every folder, with any extension. */
    private static final Pattern DEVICE = Pattern.compile("(?i)(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?");

    private FileName() {
    }

    /**
     * The name of a file.
     *
     * @param scenario the name of a scenario, may be empty
     * @return without extension, never empty
     */
    public static String of(String scenario) {
        String letters = scenario.replaceAll("[^\\p{L}\\p{N} ._-]", "_");
        String name = letters.substring(0, letters.offsetByCodePoints(0, Math.min(LONGEST, letters.codePointCount(0, letters.length()))))
                .replaceAll("^[ .]+|[ .]+$", "");
        return name.isEmpty() ? NONE : DEVICE.matcher(name).matches() ? "_" + name : name;
    }
}
