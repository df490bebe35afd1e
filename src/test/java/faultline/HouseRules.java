package faultline;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What a source file may mention, by the floor of the house that it stands on. Comments and string literals are not looked at. */
final class HouseRules {

    private static final List<String> FLOORS =
            List.of("geometry", "sensor", "robot", "world", "control", "engine", "scenario", "paint", "gui", "app");
    /** The classes that pace a run against the clock or report how fast it went; no other of their floor or below may look at one. */
    private static final Set<String> CLOCK_READERS = Set.of("engine/WorldLoop.java", "engine/Pacer.java", "engine/HeadlessRun.java");

    private static final Pattern NOT_CODE = Pattern.compile("\"\"\".*?\"\"\"|\"[^\"\\\\\n]*+(?:\\\\.[^\"\\\\\n]*+)*+\"|'\\\\?.'|//[^\n]*|/\\*.*?\\*/",
            Pattern.DOTALL);
    private static final Pattern MENTION = Pattern.compile("\\bfaultline\\.(\\w+)");
    private static final Pattern SWING = Pattern.compile("\\bjavax\\.swing\\b|\\bjava\\.awt\\.event\\b");
    private static final Pattern CLOCK = Pattern.compile(
            "\\bSystem\\.(?:currentTimeMillis|nanoTime)\\b|\\bThread\\.sleep\\b|\\bparkNanos\\b|\\bjava\\.time\\.(?:Instant|Clock|LocalDateTime)\\b");
    private static final Pattern LOOSE_MATHS = Pattern.compile("\\bMath\\.(?:sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp|expm1|log|log10"
            + "|log1p|pow|cbrt|hypot)\\b|import static java\\.lang\\.Math\\b");
    private static final Pattern CHANCE = Pattern.compile("\\bMath\\.random\\b|\\b\\w*Random\\b|\\brandomUUID\\b");

    private HouseRules() {
    }

    /**
     * What is wrong with a source file.
     *
     * @param path of the file below the folder of the root package, such as {@code world/World.java}
     * @param source its text
     * @return one sentence a fault, empty where there is none
     */
    static List<String> complaints(String path, String source) {
        int floor = FLOORS.indexOf(path.split("/")[0]);
        if (floor < 0) {
            return List.of(path + " stands on no floor");
        }
        List<String> complaints = new ArrayList<>();
        String code = NOT_CODE.matcher(source).replaceAll(" ");
        mentions(code).stream().filter(other -> !mayUse(floor, other))
                .forEach(other -> complaints.add(path + " may not know of faultline." + other));
        forbid(SWING, floor < FLOORS.indexOf("gui"), path, code, complaints);
        forbid(CLOCK, floor <= FLOORS.indexOf("engine") && !CLOCK_READERS.contains(path), path, code, complaints);
        forbid(LOOSE_MATHS, floor <= FLOORS.indexOf("engine"), path, code, complaints);
        forbid(CHANCE, floor <= FLOORS.indexOf("engine"), path, code, complaints);
        return complaints;
    }

    private static List<String> mentions(String code) {
        return MENTION.matcher(code).results().map(found -> found.group(1)).distinct().toList();
    }

    private static boolean mayUse(int floor, String other) {
        int index = FLOORS.indexOf(other);
        boolean controllerPeeks = FLOORS.get(floor).equals("control") && other.equals("world");
        return index >= 0 && index <= floor && !controllerPeeks;
    }

    private static void forbid(Pattern pattern, boolean here, String path, String code, List<String> complaints) {
        Matcher matcher = pattern.matcher(code);
        if (here && matcher.find()) {
            complaints.add(path + " may not use " + matcher.group());
        }
    }
}
