package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks the documentation of the packages in the Javadoc jar as its build does, so that plain builds check it too. */
class JavadocTest {

    private static final Path SOURCES = Path.of("src/main/java");

    /** Stops before code is generated. */
    private static final List<String> OPTIONS = List.of(
            "-Xdoclint:all/protected",
            "-Xmaxwarns",
            "1000",
            "-proc:none",
            "-implicit:none",
            "--should-stop=ifNoError=ATTR");

    @Test
    void theDocumentedPackagesAreComplete() throws IOException {
        List<String> packages = documentedPackages();
        assertTrue(packages.containsAll(List.of("faultline.geometry", "faultline.control", "faultline.scenario")));
        assertTrue(packages.stream().noneMatch(name -> name.contains(".gui")), "the window is excluded");
        assertEquals("", problems(SOURCES, packages));
    }

    @Test
    void aWrongReferenceIsFound(@TempDir Path folder) throws IOException {
        String problems = problemsOf(folder, "/** Like {@link Exemplar}. */\npublic interface Sample {}\n");
        assertTrue(problems.contains("Sample.java:3: error: reference not found"), problems);
    }

    @Test
    void aMissingCommentIsFound(@TempDir Path folder) throws IOException {
        String problems =
                problemsOf(folder, "/** Sample. */\npublic interface Sample {\n    double value(double x);\n}\n");
        assertTrue(problems.contains("Sample.java:5: warning: no comment"), problems);
    }

    private static String problemsOf(Path folder, String type) throws IOException {
        Path sources = Files.createDirectories(folder.resolve("sample"));
        Files.writeString(sources.resolve("package-info.java"), "/** Sample. */\npackage sample;\n");
        Files.writeString(sources.resolve("Sample.java"), "package sample;\n\n" + type);
        return problems(folder, List.of("sample"));
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

    /**
     * Returns the complaints about the comments of packages. The compiler finds them by the same rules as the Javadoc
     * tool does, without writing pages.
     */
    private static String problems(Path sources, List<String> packages) throws IOException {
        List<String> arguments = new ArrayList<>(OPTIONS);
        arguments.addAll(List.of("-Xdoclint/package:" + String.join(",", packages), "-sourcepath", "" + sources));
        for (String name : packages) {
            try (Stream<Path> files = Files.list(sources.resolve(name.replace('.', '/')))) {
                files.filter(file -> file.toString().endsWith(".java")).forEach(file -> arguments.add("" + file));
            }
        }
        ByteArrayOutputStream messages = new ByteArrayOutputStream();
        ToolProvider.getSystemJavaCompiler().run(null, messages, messages, arguments.toArray(String[]::new));
        return messages.toString(StandardCharsets.UTF_8);
    }
}
