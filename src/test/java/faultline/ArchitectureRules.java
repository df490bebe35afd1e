package faultline;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a source file may mention, by the floor of the house that it stands on. Comments and string literals are not
 * looked at.
 */
final class ArchitectureRules {

    private static final List<String> PACKAGE_ORDER =
            List.of("geometry", "sensor", "robot", "world", "control", "engine", "scenario", "paint", "gui", "app");
    /**
     * The classes that pace a run against the clock or report how fast it went; no other of their floor or below may
     * look at one.
     */
    private static final Set<String> CLOCK_USERS =
            Set.of("engine/WorldLoop.java", "engine/Pacer.java", "engine/HeadlessRun.java");

    private static final Pattern COMMENT_OR_LITERAL = Pattern.compile(
            "\"\"\".*?\"\"\"|\"[^\"\\\\\n]*+(?:\\\\.[^\"\\\\\n]*+)*+\"|'\\\\?.'|//[^\n]*|/\\*.*?\\*/", Pattern.DOTALL);
    private static final Pattern PACKAGE_REFERENCE = Pattern.compile("\\bfaultline\\.(\\w+)");
    private static final Pattern SWING_USE = Pattern.compile("\\bjavax\\.swing\\b|\\bjava\\.awt\\.event\\b");
    private static final Pattern CLOCK_USE = Pattern.compile(
            "\\bSystem\\.(?:currentTimeMillis|nanoTime)\\b|\\bThread\\.sleep\\b|\\bparkNanos\\b|\\bjava\\.time\\.(?:Instant|Clock|LocalDateTime)\\b");
    private static final Pattern INEXACT_MATHS =
            Pattern.compile("\\bMath\\.(?:sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp|expm1|log|log10"
                    + "|log1p|pow|cbrt|hypot)\\b|import static java\\.lang\\.Math\\b");
    private static final Pattern RANDOMNESS = Pattern.compile("\\bMath\\.random\\b|\\b\\w*Random\\b|\\brandomUUID\\b");

    private ArchitectureRules() {}

    /**
     * What is wrong with a source file.
     *
     * @param path of the file below the folder of the root package, such as {@code world/World.java}
     * @param source its text
     * @return one sentence a fault, empty where there is none
     */
    static List<String> violations(String path, String source) {
        int floor = PACKAGE_ORDER.indexOf(path.split("/")[0]);
        if (floor < 0) {
            return List.of(path + " stands on no floor");
        }
        List<String> complaints = new ArrayList<>();
        String code = COMMENT_OR_LITERAL.matcher(source).replaceAll(" ");
        referencedPackages(code).stream()
                .filter(other -> !isAllowed(floor, other))
                .forEach(other -> complaints.add(path + " may not know of faultline." + other));
        check(SWING_USE, floor < PACKAGE_ORDER.indexOf("gui"), path, code, complaints);
        check(
                CLOCK_USE,
                floor <= PACKAGE_ORDER.indexOf("engine") && !CLOCK_USERS.contains(path),
                path,
                code,
                complaints);
        check(INEXACT_MATHS, floor <= PACKAGE_ORDER.indexOf("engine"), path, code, complaints);
        check(RANDOMNESS, floor <= PACKAGE_ORDER.indexOf("engine"), path, code, complaints);
        return complaints;
    }

    private static List<String> referencedPackages(String code) {
        return PACKAGE_REFERENCE
                .matcher(code)
                .results()
                .map(found -> found.group(1))
                .distinct()
                .toList();
    }

    private static boolean isAllowed(int floor, String other) {
        int index = PACKAGE_ORDER.indexOf(other);
        boolean controllerPeeks = PACKAGE_ORDER.get(floor).equals("control") && other.equals("world");
        return index >= 0 && index <= floor && !controllerPeeks;
    }

    private static void check(Pattern pattern, boolean here, String path, String code, List<String> complaints) {
        Matcher matcher = pattern.matcher(code);
        if (here && matcher.find()) {
            complaints.add(path + " may not use " + matcher.group());
        }
    }
}
