package faultline.app;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Random command lines: each ends with a documented exit code and clear lines, never with an exception that escaped.
 * The system property {@code faultline.fuzz} sets their number to a tenth of it.
 */
class CommandLineFuzzTest {

    private static final int COUNT = Integer.getInteger("faultline.fuzz", 3000) / 10;

    private static final List<String> COMMANDS = List.of(
            "run", "check", "compare", "import", "merge", "report", "campaign", "--help", "--version", "rnu", "");

    private static final List<String> OPTIONS = List.of(
            "--until",
            "--seed",
            "--threads",
            "--trace",
            "--trace-format",
            "--film",
            "--pace=0",
            "--pace=1000",
            "--controller",
            "--jar",
            "--table",
            "--seeds",
            "--image",
            "--journal",
            "--json",
            "--out",
            "--resolution",
            "--threshold",
            "--negate",
            "--unknown",
            "--min-cells",
            "--smooth",
            "--start",
            "--jobs",
            "--shard",
            "--resume",
            "--truth",
            "--patience",
            "--sede",
            "-",
            "--",
            "--until=0.1",
            "--seed=x");

    private static final Set<String> OUTPUTS = Set.of("--trace", "--image", "--journal", "--film", "--table", "--out");

    private static final List<String> VALUES = List.of(
            "0",
            "0.05",
            "-1",
            "1e999",
            "NaN",
            "1/2",
            "9/2",
            "none",
            "wall-follower",
            "false",
            "\"open quote",
            "2",
            "controller",
            "free",
            "1,1,0",
            "\u0661",
            "\u202e",
            "\u001b[2J",
            "a\nb",
            "x".repeat(300),
            " ");

    @TempDir
    private Path folder;

    private final SplittableRandom random = new SplittableRandom(Long.getLong("faultline.fuzz.seed", 2718));

    private String pick(List<String> words) {
        return words.get(random.nextInt(words.size()));
    }

    private List<String> files() throws IOException {
        Path good = Files.copy(Path.of("scenarios/beside-a-wall.xml"), folder.resolve("good.xml"));
        Path link = Files.createSymbolicLink(folder.resolve("link.xml"), good);
        Path bad = Files.writeString(folder.resolve("bad.xml"), "<scenario/>");
        Path map = Files.writeString(folder.resolve("map.pgm"), "P2\n3 3\n255\n0 0 0 0 255 0 0 0 0\n");
        Path yaml = Files.writeString(folder.resolve("map.yaml"), "image: map.pgm\nresolution: 1\n");
        return List.of(
                good.toString(),
                link.toString(),
                bad.toString(),
                map.toString(),
                yaml.toString(),
                folder.toString(),
                folder.resolve("out").toString(),
                folder.resolve("a\n\u202eb").toString(),
                folder.resolve("none/out").toString(),
                "/dev/null",
                "/dev/full");
    }

    private String argument(List<String> files) {
        return switch (random.nextInt(4)) {
            case 0 -> pick(files);
            case 1 -> pick(VALUES);
            default -> pick(OPTIONS);
        };
    }

    @Test
    void randomCommandLinesEndWithADocumentedExitCode() throws IOException {
        List<String> files = files();
        for (int i = 0; i < COUNT; i++) {
            List<String> arguments = new ArrayList<>(List.of(pick(COMMANDS)));
            if (random.nextInt(3) > 0) {
                arguments.add(files.get(random.nextInt(5)));
            }
            for (int k = random.nextInt(6); k > 0; k--) {
                String argument = argument(files);
                arguments.add(argument);
                if (OUTPUTS.contains(argument)) {
                    // Nothing is written outside the test's folder.
                    arguments.add(pick(files));
                }
            }
            if (List.of("run", "compare").contains(arguments.get(0)) && !arguments.contains("--until")) {
                arguments.addAll(List.of("--until", "0.2"));
            }
            check(arguments);
        }
    }

    private static void check(List<String> arguments) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        CommandOutput output = new CommandOutput(
                new PrintStream(out, true, StandardCharsets.UTF_8), new PrintStream(err, true, StandardCharsets.UTF_8));
        int code = new CommandLine(output).run(arguments.toArray(String[]::new));
        String message = err.toString(StandardCharsets.UTF_8);
        assertTrue(code >= 0 && code <= 3, arguments + " ended with " + code);
        assertFalse(
                message.contains("the program failed") || message.contains("Exception"), arguments + ": " + message);
        assertTrue(code == 0 || !message.isBlank(), arguments + " ended with " + code + " and no word");
        assertTrue((out + message).codePoints().noneMatch(c -> c == 0x1b || c == 0x202e), arguments + ": " + message);
    }
}
