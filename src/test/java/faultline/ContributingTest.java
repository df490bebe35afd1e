package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The lists of files in {@code docs/contributing.md} are complete, and the decisions are all listed. */
class ContributingTest {

    private static final Path PAGE = Path.of("docs/contributing.md");
    private static final Path DECISIONS = Path.of("docs/decisions");
    private static final Pattern RECIPE = Pattern.compile("### (.*)\n\nThe example is (.*)\\.\n\n((?:\\|.*\n)+)");
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)]+)\\)");

    @Test
    void everyFileThatTheExampleTouchesIsListed() throws IOException {
        List<MatchResult> recipes =
                RECIPE.matcher(Files.readString(PAGE)).results().toList();
        assertEquals(6, recipes.size());
        for (MatchResult recipe : recipes) {
            Set<Path> listed = matches(LINK, recipe.group(3))
                    .map(link -> PAGE.resolveSibling(link).normalize())
                    .collect(Collectors.toCollection(TreeSet::new));
            Set<Path> missing = new TreeSet<>(touched(
                    matches(CODE, recipe.group(2)).toList(), recipe.group(1).contains("figure")));
            assertTrue(missing.size() > 1, recipe.group(1) + ": the example is gone");
            missing.removeAll(listed);
            assertEquals(Set.of(), missing, recipe.group(1));
        }
    }

    @Test
    void everyDecisionIsDatedAndListed() throws IOException {
        String index = Files.readString(DECISIONS.resolve("README.md"));
        List<String> wrong = new ArrayList<>();
        try (Stream<Path> pages = Files.list(DECISIONS)) {
            for (Path page : pages.filter(file -> !file.endsWith("README.md")).toList()) {
                List<String> lines = Files.readAllLines(page);
                String title = lines.get(0).replaceFirst("^# \\d{4}: ", "");
                if (!index.contains("[" + title + "](" + page.getFileName() + ")")) {
                    wrong.add(page + " is not listed under its title");
                }
                if (!lines.get(2).matches("Accepted on \\d{4}-\\d\\d-\\d\\d.*")) {
                    wrong.add(page + " has no date below its title");
                }
            }
        }
        assertEquals(List.of(), wrong);
    }

    /** Returns the files that contain one of the words: sources and, for a figure, results and studies, too. */
    private static Set<Path> touched(List<String> words, boolean figure) throws IOException {
        Pattern word = Pattern.compile(
                "\\b(?:" + words.stream().map(Pattern::quote).collect(Collectors.joining("|")) + ")\\b");
        List<Path> searched =
                new ArrayList<>(List.of(Path.of("docs/scenario-1.xsd"), Path.of("docs/scenario-format.md")));
        try (Stream<Path> sources = Files.walk(Path.of("src/main"))) {
            sources.filter(Files::isRegularFile)
                    .filter(file -> !file.toString().endsWith(".html"))
                    .filter(file -> figure || !file.toString().matches(".*[/\\\\](studies|campaign)[/\\\\].*"))
                    .forEach(searched::add);
        }
        if (figure) {
            searched.add(Path.of("docs/results.md"));
            try (Stream<Path> results = Files.list(Path.of("docs/results"))) {
                results.filter(Files::isRegularFile).forEach(searched::add);
            }
        }
        return searched.stream()
                .filter(file ->
                        word.matcher(file.getFileName() + " " + text(file)).find())
                .collect(Collectors.toSet());
    }

    private static String text(Path file) {
        try {
            String text = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
            return file.toString().endsWith(".java") ? COMMENT.matcher(text).replaceAll(" ") : text;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Stream<String> matches(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(found -> found.group(1));
    }
}
