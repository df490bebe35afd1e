package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks the documentation of the packages in the Javadoc jar as its build does, so that plain builds check it too. */
class JavadocTest {

    private static final Path SOURCES = Path.of("src/main/java");

    /** Generates nothing that is not checked. */
    private static final List<String> OPTIONS = List.of(
            "-quiet", "-Xdoclint:all", "-Xmaxwarns", "1000", "-noindex", "-notree", "-nonavbar", "-nohelp", "-nosince");

    @Test
    void theDocumentedPackagesAreComplete(@TempDir Path output) throws IOException {
        List<String> packages = documentedPackages();
        assertTrue(packages.containsAll(List.of("faultline.geometry", "faultline.control", "faultline.scenario")));
        assertTrue(packages.stream().noneMatch(name -> name.contains(".gui")), "the window is excluded");
        assertEquals("", javadoc(SOURCES, output, packages));
    }

    @Test
    void aMissingCommentIsFound(@TempDir Path folder) throws IOException {
        Path sources = Files.createDirectories(folder.resolve("sample"));
        Files.writeString(sources.resolve("package-info.java"), "/** Sample. */\npackage sample;\n");
        Files.writeString(
                sources.resolve("Sample.java"),
                "package sample;\n\n/** Sample. */\npublic interface Sample {\n    double value(double x);\n}\n");
        String problems = javadoc(folder, folder.resolve("output"), List.of("sample"));
        assertTrue(problems.contains("Sample.java:5: warning: no comment"), problems);
    }

    /** Returns the packages that are not excluded from the Javadoc jar. */
    private static List<String> documentedPackages() throws IOException {
        Matcher excluded = Pattern.compile("<excludePackageNames>([^<]+)</excludePackageNames>")
                .matcher(Files.readString(Path.of("pom.xml")));
        assertTrue(excluded.find());
        List<String> patterns = List.of(excluded.group(1).split(":"));
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.endsWith("package-info.java"))
                    .map(file -> SOURCES.relativize(file.getParent()).toString().replaceAll("[/\\\\]", "."))
                    .filter(name -> patterns.stream().noneMatch(pattern -> isMatch(pattern, name)))
                    .sorted()
                    .toList();
        }
    }

    /** Returns whether a pattern of the build matches a package: its name, or {@code NAME.*} for those below. */
    private static boolean isMatch(String pattern, String name) {
        return pattern.endsWith(".*")
                ? name.startsWith(pattern.substring(0, pattern.length() - 1))
                : name.equals(pattern);
    }

    private static String javadoc(Path sources, Path output, List<String> packages) {
        List<String> arguments = new ArrayList<>(OPTIONS);
        arguments.addAll(List.of("-d", output.toString(), "-sourcepath", sources.toString()));
        arguments.addAll(packages);
        StringWriter messages = new StringWriter();
        PrintWriter writer = new PrintWriter(messages, true);
        ToolProvider.findFirst("javadoc").orElseThrow().run(writer, writer, arguments.toArray(String[]::new));
        return messages.toString();
    }
}
