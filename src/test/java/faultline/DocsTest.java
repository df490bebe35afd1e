package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Everything that the documentation names exists: files, classes and members. */
class DocsTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)(?:#[^)]*)?\\)");
    private static final Pattern ANCHOR = Pattern.compile("\\]\\(([^)#:]*)#([^)]+)\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");
    private static final Pattern CODE = Pattern.compile("`([^`\n]+)`");
    private static final Pattern CLASS_NAME =
            Pattern.compile("(?:[a-z]+\\.)*([A-Z]\\w+[a-z]\\w*)((?:\\.\\w+)*)(?:\\(.*\\))?");
    private static final long MAX_PICTURE_BYTES = 1_250_000;
    private static final Pattern FENCED = Pattern.compile("(?ms)^```.*?^```");

    /** The most classes that each of the paths through the code may have, in the order of the page. */
    private static final List<Integer> MAX_CLASSES = List.of(12, 14, 16, 17);

    /**
     * The successive classes on those paths that do not name each other: an interface, a function or an earlier class
     * of the path is between them.
     */
    private static final List<String> JOINED_BY_ANOTHER = List.of(
            "Simulation → ThreadedHost",
            "PeriodicController → FaultTolerantFollower",
            "WallTracker → Velocity",
            "ScenarioReader → XmlParser",
            "AttributeReader → SensorSpec",
            "PendingEdits → RunController",
            "SensorArray → CommandResult",
            "Frame → RunPoller",
            "CanvasModel → BackBuffer",
            "BackBuffer → Snapshot",
            "LayerImage → GroundLayer");

    /** Names that are not ours: the JDK's, and those of other programs. */
    private static final Set<String> OTHER_NAMES = Set.of(
            "AffineTransform",
            "AssertionError",
            "AtomicReference",
            "AutoCloseable",
            "Graphics2D",
            "IEEEremainder",
            "Locale",
            "Math",
            "Optional",
            "Random",
            "Runtime",
            "SplittableRandom",
            "StrictMath",
            "System",
            "UndoManager",
            "VolatileImage");

    @Test
    void everyLinkTargetExists() throws IOException {
        List<String> dead = new ArrayList<>();
        for (Path page : pages()) {
            LINK.matcher(Files.readString(page))
                    .results()
                    .map(found -> found.group(1))
                    .filter(link -> !link.contains("://"))
                    .filter(link -> Files.notExists(page.resolveSibling(link)))
                    .forEach(link -> dead.add(page + ": " + link));
        }
        assertEquals(List.of(), dead);
    }

    @Test
    void everyHeadingThatALinkNamesExists() throws IOException {
        List<String> dead = new ArrayList<>();
        for (Path page : pages()) {
            for (MatchResult link :
                    ANCHOR.matcher(Files.readString(page)).results().toList()) {
                Path target = link.group(1).isEmpty() ? page : page.resolveSibling(link.group(1));
                if (!anchors(target).contains(link.group(2))) {
                    dead.add(page + ": " + link.group());
                }
            }
        }
        assertEquals(List.of(), dead);
    }

    /** Returns the anchors that hosts of repositories give the headings of a page. */
    private static Set<String> anchors(Path page) throws IOException {
        return HEADING.matcher(FENCED.matcher(Files.readString(page)).replaceAll(""))
                .results()
                .map(found -> found.group(1).toLowerCase(Locale.ROOT))
                .map(heading -> heading.replaceAll("[^\\w\\- ]", "").replace(' ', '-'))
                .collect(Collectors.toSet());
    }

    @Test
    void theClassesOnAPathThroughTheCodeUseEachOther() throws IOException {
        String page = Files.readString(Path.of("docs/architecture.md")).replace("\n  ", " ");
        List<String> wrong = new ArrayList<>();
        List<String> joined = new ArrayList<>();
        List<MatchResult> paths = Pattern.compile("(?m)^- .* \\((\\d+) classes\\): (`.*)$")
                .matcher(page)
                .results()
                .toList();
        assertEquals(MAX_CLASSES.size(), paths.size());
        for (int p = 0; p < paths.size(); p++) {
            MatchResult path = paths.get(p);
            assertTrue(Integer.parseInt(path.group(1)) <= MAX_CLASSES.get(p), path.group());
            List<String> names = List.of(path.group(2).replace("`", "").split(" → "));
            assertEquals(Integer.parseInt(path.group(1)), Set.copyOf(names).size(), path.group());
            List<String> sources = new ArrayList<>();
            for (String name : names) {
                sources.add(Files.readString(sourceOf(name)));
            }
            for (int i = 0; i < names.size(); i++) {
                if (!isUsed(i, names, sources)) {
                    wrong.add(names.get(i) + " in " + path.group());
                }
                if (i > 0 && !isUsed(i, i - 1, names, sources)) {
                    joined.add(names.get(i - 1) + " → " + names.get(i));
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertEquals(JOINED_BY_ANOTHER, joined);
    }

    /** Returns whether a class on a path names another one on it, or is named by it. */
    private static boolean isUsed(int index, List<String> names, List<String> sources) {
        return IntStream.range(0, names.size())
                .filter(other -> other != index)
                .anyMatch(other -> isUsed(index, other, names, sources));
    }

    private static boolean isUsed(int index, int other, List<String> names, List<String> sources) {
        return names(sources.get(other), names.get(index)) || names(sources.get(index), names.get(other));
    }

    private static boolean names(String source, String name) {
        return Pattern.compile("\\b" + name + "\\b").matcher(source).find();
    }

    private static Path sourceOf(String name) throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            return files.filter(file -> file.endsWith(name + ".java"))
                    .findFirst()
                    .orElseThrow(() -> new AssertionError("there is no class " + name));
        }
    }

    @Test
    void everyPictureIsShownAndAllAreSmall() throws IOException {
        StringBuilder text = new StringBuilder();
        for (Path page : pages()) {
            text.append(Files.readString(page));
        }
        List<Path> hidden = new ArrayList<>();
        long bytes = 0;
        for (Path picture : files(Path.of("docs/images"))) {
            bytes += Files.size(picture);
            if (!text.toString().contains("images/" + picture.getFileName() + ")")) {
                hidden.add(picture);
            }
        }
        assertEquals(List.of(), hidden, "pictures that no page shows; src/conf/screenshots writes them to target");
        assertTrue(bytes < MAX_PICTURE_BYTES, "docs/images has " + bytes + " bytes");
    }

    @Test
    void everyClassAndMemberThatIsNamedIsInTheSource() throws IOException {
        SourceNames names = SourceNames.read();
        Set<String> unknown = new TreeSet<>();
        int count = 0;
        for (Path page : pages()) {
            String text = FENCED.matcher(Files.readString(page)).replaceAll("");
            for (String code :
                    CODE.matcher(text).results().map(found -> found.group(1)).toList()) {
                var name = CLASS_NAME.matcher(code);
                if (name.matches() && !OTHER_NAMES.contains(name.group(1))) {
                    count++;
                    if (!names.contains(name.group(1), name.group(2))) {
                        unknown.add(page + ": " + code);
                    }
                }
            }
        }
        assertTrue(count > 150, "the documentation names few classes: " + count);
        assertEquals(Set.of(), unknown);
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }

    static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("docs"))) {
            return Stream.concat(Stream.of(Path.of("README.md")), files.filter(file -> file.toString()
                            .endsWith(".md")))
                    .sorted()
                    .toList();
        }
    }
}
