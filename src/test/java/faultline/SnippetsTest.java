package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs every snippet of the documentation. Commands of the program run in a separate folder, each in a process without
 * a display; it has the shipped scenarios, the examples, the README's {@code room.xml}, the map {@code flat.pgm} of the
 * page about floor plans, and the client and the program of the page about controllers.
 */
class SnippetsTest {

    private static final String JAR = "java -jar target/faultline.jar";
    private static final boolean HAS_PYTHON = Stream.of(
                    System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, "python3")));
    private static final Pattern WORD = Pattern.compile("\"[^\"]*\"|[^ ]+");
    private static final Pattern MAVEN_TESTS = Pattern.compile("-D(?:it\\.)?test='?([\\w,]+)'?");

    @TempDir
    private Path folder;

    /** A fenced block of a page. */
    record Snippet(Path page, String text) {
        @Override
        public String toString() {
            return page + ": " + text.lines().findFirst().orElse("").strip();
        }
    }

    @BeforeEach
    void makeFolder() throws IOException {
        for (Path shared : List.of(Path.of("scenarios"), Path.of("docs/examples"))) {
            try (Stream<Path> files = Files.walk(shared)) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    Path copy = folder.resolve(file.toString());
                    Files.createDirectories(copy.getParent());
                    Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
                }
            }
        }
        Files.writeString(folder.resolve("room.xml"), room());
        Files.writeString(folder.resolve("flat.pgm"), flat());
        for (String name : List.of("faultline.py", "my_follower.py")) {
            Files.copy(Path.of("docs/examples/python", name), folder.resolve(name));
        }
    }

    @ParameterizedTest
    @MethodSource("scenarios")
    void everyScenarioIsValidAndHoldsItsExpectation(Snippet snippet) throws Exception {
        Files.writeString(folder.resolve("snippet.xml"), snippet.text());
        run("check snippet.xml", Set.of(0));
        assertTrue(run("run snippet.xml", Set.of(0)).contains("trajectory_hash: "));
    }

    static Stream<Snippet> scenarios() throws IOException {
        return snippets("xml").filter(snippet -> snippet.text().contains("<scenario"));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyCommandRuns(Snippet snippet) throws Exception {
        // The shipped expectations are those of the built-in follower.
        Set<Integer> allowed = snippet.text().contains("--controller") ? Set.of(0, 1) : Set.of(0);
        run(snippet.text().substring(JAR.length()).strip(), allowed);
    }

    /**
     * Every line that runs the program. {@code FiguresTest} runs the figures, which take a minute, and the script
     * {@code src/conf/test-campaigns} runs campaigns, whose commands need what others have made.
     */
    static Stream<Snippet> commands() throws IOException {
        return lines().filter(snippet -> snippet.text().startsWith(JAR))
                .filter(snippet -> !snippet.text().startsWith(JAR + " figures"))
                .filter(snippet -> !snippet.text().substring(JAR.length()).matches(" (campaign|merge|report) .*"))
                .filter(snippet -> !snippet.text().contains("python3") || HAS_PYTHON);
    }

    @ParameterizedTest
    @MethodSource("javaSnippets")
    void everyJavaSnippetCompilesAndRuns(Snippet snippet) throws Exception {
        Path source = folder.resolve("Snippet.java");
        int statements = snippet.text().lastIndexOf("import ");
        statements = snippet.text().indexOf('\n', statements);
        Files.writeString(
                source,
                """
                %s
                public class Snippet {
                    public static void run() throws Exception {
                        %s
                    }
                }
                """
                        .formatted(
                                snippet.text().substring(0, statements),
                                snippet.text().substring(statements)));
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        assertEquals(0, compiler.run(null, null, null, "-cp", classPath(), "" + source));
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {folder.toUri().toURL()}, SnippetsTest.class.getClassLoader())) {
            loader.loadClass("Snippet").getMethod("run").invoke(null);
        }
    }

    static Stream<Snippet> javaSnippets() throws IOException {
        return snippets("java");
    }

    @Test
    void theErrorMessagesInTheFormatsPageAreThoseOfTheProgram() throws Exception {
        Files.writeString(
                folder.resolve("room.xml"),
                room().replace("<rectangle", "<rectangel").replace("\"stuck\"", "\"stick\""));
        Snippet expected = snippets("")
                .filter(snippet -> snippet.text().startsWith("room.xml:"))
                .findFirst()
                .orElseThrow();
        assertEquals(expected.text(), run("check room.xml", Set.of(2)));
    }

    @Test
    void theSummaryThatTheReadmeQuotesIsThatOfTheProgram() throws Exception {
        Snippet expected = snippets("text")
                .filter(snippet -> snippet.page().endsWith("README.md"))
                .findFirst()
                .orElseThrow();
        List<String> summary = run("run room.xml", Set.of(0)).lines().toList();
        assertEquals(
                expected.text().lines().toList(),
                summary.stream()
                        .filter(line -> line.matches("(rung|health)_changes: .*"))
                        .toList());
    }

    @Test
    void everyTestAndScriptThatACommandNamesExists() throws IOException {
        SourceNames names = SourceNames.read();
        List<String> missing = new ArrayList<>();
        for (Path page : DocsTest.pages()) {
            MAVEN_TESTS.matcher(Files.readString(page)).results().forEach(found -> Arrays.stream(
                            found.group(1).split(","))
                    .filter(name -> !names.contains(name, ""))
                    .forEach(name -> missing.add(page + ": " + name)));
        }
        lines().map(snippet -> snippet.text().split(" ")[0])
                .filter(command -> command.contains("/"))
                .filter(command -> !Files.isExecutable(Path.of(command)))
                .forEach(missing::add);
        assertEquals(List.of(), missing);
    }

    private String run(String arguments, Set<Integer> allowed) throws Exception {
        List<String> program = JavaProcess.program();
        program.add(1, "-Djava.awt.headless=true");
        List<String> command = WORD.matcher((JAR + " " + arguments).replace(JAR, String.join(" ", program)))
                .results()
                .map(word -> word.group().replace("\"", ""))
                .toList();
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String output = JavaProcess.output(process);
        assertTrue(allowed.contains(process.waitFor()), output);
        return output;
    }

    private static String classPath() {
        return String.join(
                File.pathSeparator,
                PackageGraph.compiledClasses().toString(),
                Path.of(URI.create(""
                                + Test.class
                                        .getProtectionDomain()
                                        .getCodeSource()
                                        .getLocation()))
                        .toString(),
                System.getProperty("java.class.path"));
    }

    private static String room() throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        assertTrue(readme.contains("Save this as `room.xml`"));
        return scenarios()
                .filter(snippet -> snippet.page().endsWith("README.md"))
                .findFirst()
                .orElseThrow()
                .text();
    }

    private static String flat() throws IOException {
        return snippets("pgm").findFirst().orElseThrow().text();
    }

    /** Returns the lines of all shell snippets, without comments; a line with "&amp;&amp;" as two. */
    private static Stream<Snippet> lines() throws IOException {
        return Stream.concat(snippets("sh"), snippets("")).flatMap(snippet -> snippet.text()
                .lines()
                .flatMap(line -> Stream.of(line.replaceFirst(" *#.*", "").split(" && ")))
                .map(String::strip)
                .map(line -> new Snippet(snippet.page(), line)));
    }

    private static Stream<Snippet> snippets(String language) throws IOException {
        Pattern block = Pattern.compile("(?ms)^```" + language + "\n(.*?)^```$");
        List<Snippet> found = new ArrayList<>();
        for (Path page : DocsTest.pages()) {
            String text = Files.readString(page);
            if (language.isEmpty()) {
                text = text.replaceAll("(?ms)^```\\w+\n.*?^```$", "");
            }
            block.matcher(text).results().forEach(match -> found.add(new Snippet(page, match.group(1))));
        }
        return found.stream();
    }
}
