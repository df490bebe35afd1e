package faultline;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What a source file may use, by its package. Comments and string literals are ignored. */
final class LayerRules {

    /** All packages below the root package, lowest first: a package may use only those before it. */
    static final List<String> PACKAGE_ORDER = List.of(
            "geometry",
            "io",
            "sensor",
            "robot",
            "control",
            "world",
            "control.wallfollower",
            "control.diagnosis",
            "control.fallback",
            "control.ladder",
            "engine",
            "engine.recording",
            "engine.walls",
            "engine.metrics",
            "engine.trace",
            "engine.session",
            "scenario.xml",
            "scenario",
            "floorplan",
            "campaign",
            "external",
            "paint.surface",
            "paint.chart",
            "paint.scene",
            "paint.export",
            "campaign.plan",
            "campaign.run",
            "campaign.report",
            "gui.text",
            "gui.theme",
            "gui.settings",
            "gui.form",
            "gui.change",
            "gui.document",
            "gui.edit",
            "gui.canvas.cache",
            "gui.canvas.tool",
            "gui.canvas",
            "gui.panel",
            "gui.motor",
            "gui.action",
            "gui.bar",
            "gui.timeline",
            "gui.instrument",
            "gui.properties",
            "gui.gallery",
            "gui.dialog",
            "gui.export",
            "gui.batch",
            "gui.window",
            "gui",
            "studies.figure",
            "studies",
            "app");

    /** The classes of the engine and below that may read a clock: they pace a run or report its speed. */
    private static final Set<String> CLOCK_USERS =
            Set.of("engine/session/Pacer.java", "engine/metrics/HeadlessRun.java");

    /** The class below the engine that may use randomness: it gives temporary files their names. */
    private static final String RANDOM_NAMES = "io/TemporaryFile.java";

    private static final Pattern COMMENT_OR_LITERAL = Pattern.compile(
            "\"\"\".*?\"\"\"|\"[^\"\\\\\n]*+(?:\\\\.[^\"\\\\\n]*+)*+\"|'\\\\?.'|//[^\n]*|/\\*.*?\\*/", Pattern.DOTALL);
    private static final Pattern PACKAGE_REFERENCE = Pattern.compile("\\bfaultline\\.([a-z]\\w*(?:\\.[a-z]\\w*)*)");
    private static final Pattern SWING_USE = Pattern.compile("\\bjavax\\.swing\\b|\\bjava\\.awt\\.event\\b");
    private static final Pattern CLOCK_USE =
            Pattern.compile("\\bSystem\\.(?:currentTimeMillis|nanoTime)\\b|\\bThread\\.sleep\\b|\\bparkNanos"
                    + "\\b|\\bjava\\.time\\.(?:Instant|Clock|LocalDateTime)\\b");
    private static final Pattern INEXACT_MATHS =
            Pattern.compile("\\bMath\\.(?:sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp|expm1|log|log10"
                    + "|log1p|pow|cbrt|hypot)\\b|import static java\\.lang\\.Math\\b");
    private static final Pattern RANDOMNESS =
            Pattern.compile("\\bMath\\.random\\b|\\b(?!SensorRandom\\b)\\w*Random\\b|\\brandomUUID\\b");
    /** The window sends its commands through undo and the document, although a session would accept them directly. */
    private static final Pattern SESSION_USE = Pattern.compile("\\bengine\\.session\\.(?:Session\\b|\\*)");

    private LayerRules() {}

    /**
     * Returns the rules that a source file breaks.
     *
     * @param path of the file below the folder of the root package, such as {@code world/World.java}
     * @param source its text
     * @return one sentence for each violation, empty if there is none
     */
    static List<String> violations(String path, String source) {
        String ownPackage =
                path.substring(0, Math.max(0, path.lastIndexOf('/'))).replace('/', '.');
        int layer = PACKAGE_ORDER.indexOf(ownPackage);
        if (layer < 0) {
            return List.of(path + " is in no declared package");
        }
        List<String> violations = new ArrayList<>();
        String code = COMMENT_OR_LITERAL.matcher(source).replaceAll(" ");
        code = code.replaceFirst("\\bpackage [\\w.]+;", "");
        referencedPackages(code).stream()
                .filter(other -> !isAllowed(layer, other))
                .forEach(other -> violations.add(path + " may not use faultline." + other));
        boolean isModel = layer < PACKAGE_ORDER.indexOf("scenario.xml");
        boolean isWithoutSwing = layer < PACKAGE_ORDER.indexOf("gui.text") || ownPackage.equals("gui.change");
        check(SWING_USE, isWithoutSwing, path, code, violations);
        check(CLOCK_USE, isModel && !CLOCK_USERS.contains(path), path, code, violations);
        check(INEXACT_MATHS, isModel, path, code, violations);
        check(RANDOMNESS, isModel && !path.equals(RANDOM_NAMES), path, code, violations);
        check(SESSION_USE, ownPackage.startsWith("gui") && !ownPackage.equals("gui.document"), path, code, violations);
        return violations;
    }

    private static List<String> referencedPackages(String code) {
        return PACKAGE_REFERENCE
                .matcher(code)
                .results()
                .map(found -> found.group(1))
                .distinct()
                .toList();
    }

    private static boolean isAllowed(int layer, String other) {
        int index = PACKAGE_ORDER.indexOf(other);
        boolean controllerSeesTruth =
                PACKAGE_ORDER.get(layer).startsWith("control") && (other.equals("world") || other.startsWith("world."));
        return index >= 0 && index <= layer && !controllerSeesTruth;
    }

    private static void check(Pattern pattern, boolean applies, String path, String code, List<String> violations) {
        Matcher matcher = pattern.matcher(code);
        if (applies && matcher.find()) {
            violations.add(path + " may not use " + matcher.group());
        }
    }
}
