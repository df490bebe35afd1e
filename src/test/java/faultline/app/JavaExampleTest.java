package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.campaign.plan.SamplePlan;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The Java project of the examples, built as its users build it, and run from its jar. */
class JavaExampleTest {

    private static final Path PROJECT = Path.of("docs/examples/java/src/main");

    @TempDir
    private Path folder;

    private final ClassLoader before = Thread.currentThread().getContextClassLoader();
    private Path jar;

    @BeforeEach
    void build() throws Exception {
        Path classes = Files.createDirectory(folder.resolve("classes"));
        List<String> arguments = new ArrayList<>(List.of(
                "-Xlint:all",
                "-Werror",
                "-cp",
                Path.of(ControllerProvider.class
                                .getProtectionDomain()
                                .getCodeSource()
                                .getLocation()
                                .toURI())
                        .toString(),
                "-d",
                classes.toString()));
        files(PROJECT.resolve("java")).forEach(file -> arguments.add(file.toString()));
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, arguments.toArray(new String[0])));
        jar = folder.resolve("my-controller.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            add(classes, out);
            add(PROJECT.resolve("resources"), out);
        }
    }

    @AfterEach
    void forgetJar() {
        Thread.currentThread().setContextClassLoader(before);
    }

    private static List<Path> files(Path root) throws IOException {
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        }
    }

    private static void add(Path root, JarOutputStream out) throws IOException {
        for (Path file : files(root)) {
            out.putNextEntry(new JarEntry(root.relativize(file).toString().replace('\\', '/')));
            out.write(Files.readAllBytes(file));
        }
    }

    private static String run(String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream stream = new PrintStream(out, true, StandardCharsets.UTF_8);
        new CommandLine(new CommandOutput(stream, stream)).run(arguments);
        return out.toString(StandardCharsets.UTF_8);
    }

    private static String value(String output, String key) {
        return output.lines()
                .filter(line -> line.startsWith(key + ": "))
                .findFirst()
                .orElseThrow(() -> new AssertionError(output))
                .substring(key.length() + 2);
    }

    @Test
    void theExampleFollowsTheWallOfTheYard() {
        String output = run("run", "scenarios/yard.xml", "--controller", "my-follower", "--jar", jar.toString());
        assertEquals("none", value(output, "collision"));
        assertTrue(Double.parseDouble(value(output, "coverage")) > 0.8, output);
        assertEquals("EXTERN SEARCH TURN FOLLOW", value(output, "states"));
        // Each run of the program finds the controllers of the jar itself.
        forgetJar();
        assertEquals(
                value(output, "trajectory_hash"),
                value(
                        run(
                                "run",
                                "scenarios/yard.xml",
                                "--threads",
                                "controller",
                                "--controller",
                                "my-follower",
                                "--jar",
                                jar.toString()),
                        "trajectory_hash"));
    }

    @Test
    void theOtherCommandsThatReadAScenarioTakeTheJarToo() throws Exception {
        String file = yardOfTheExample().toString();
        assertEquals(file + ": good\n", run("check", file, "--jar", jar.toString()));
        forgetJar();
        assertTrue(run("check", file).contains("type of <controller> is \"my-follower\""));
        InputStream input = System.in;
        try {
            System.setIn(InputStream.nullInputStream());
            assertTrue(run("serve", file, "--truth", "--jar", jar.toString()).startsWith("{\"type\":\"hello\""));
            forgetJar();
            assertEquals("", run("controller", file, "--jar", jar.toString()));
        } finally {
            System.setIn(input);
        }
    }

    /** Runs a command with a jar and nothing from earlier jars; {@code @} is the folder. Returns the last line. */
    private String runWith(Path controllers, String arguments) {
        forgetJar();
        String command = arguments.replace("@", folder.toString()) + " --jar " + controllers;
        String output = run(command.split(" ")).replace(folder.toString(), "@").strip();
        return output.substring(output.lastIndexOf('\n') + 1);
    }

    private Path writePlan() throws IOException {
        yardOfTheExample();
        return Files.writeString(
                folder.resolve("plan.xml"),
                SamplePlan.text(
                        "",
                        """
                        <worlds><scenario file="yard.xml"/><rooms/></worlds>
                        <set attribute="@duration" value="1"/>
                        <set attribute="controller/@type" value="my-follower"/>
                        <set attribute="controller/setting[distance]/@value" value="0.3 0.4"/>
                        """));
    }

    /** Returns a jar with the same controllers and other bytes. */
    private Path changedJar() throws IOException {
        Path changed = folder.resolve("changed.jar");
        try (JarFile in = new JarFile(jar.toFile());
                JarOutputStream out = new JarOutputStream(Files.newOutputStream(changed))) {
            for (JarEntry entry : Collections.list(in.entries())) {
                out.putNextEntry(new JarEntry(entry.getName()));
                in.getInputStream(entry).transferTo(out);
            }
            out.putNextEntry(new JarEntry("changed"));
        }
        return changed;
    }

    @Test
    void aCampaignOfTheExampleIsMadeInPartsMergedAndReported() throws Exception {
        writePlan();
        assertEquals("broken: 0", runWith(jar, "campaign @/plan.xml --out @/whole"));
        assertEquals("broken: 0", runWith(jar, "campaign @/plan.xml --out @/a --shard 1/2"));
        Path copy = Files.copy(jar, folder.resolve("copy.jar"));
        assertEquals("broken: 0", runWith(copy, "campaign @/plan.xml --out @/b --shard 2/2"));
        assertEquals("broken: 0", runWith(jar, "merge @/a @/b --out @/merged"));
        for (String file : List.of("runs.csv", "campaign.json")) {
            assertEquals(
                    Files.readString(folder.resolve("whole").resolve(file)),
                    Files.readString(folder.resolve("merged").resolve(file)));
        }
        assertEquals("runs: 4", runWith(jar, "report @/merged --out @/page.html"));
        String replay = runWith(jar, "run @/merged/replays/run-0000003.xml --json");
        String hash =
                Files.readAllLines(folder.resolve("whole/runs.csv")).get(4).replaceFirst(",+$", "");
        assertTrue(replay.contains(hash.substring(hash.lastIndexOf(',') + 1)), replay);
    }

    @Test
    void theJarIsPartOfACampaign() throws Exception {
        writePlan();
        Path changed = changedJar();
        assertEquals("broken: 0", runWith(jar, "campaign @/plan.xml --out @/whole"));
        assertEquals("broken: 0", runWith(jar, "campaign @/plan.xml --out @/whole --resume"));
        String why = "or was made by another program or with another jar of a controller";
        assertEquals(
                "faultline: @/whole: the campaign there has another plan, " + why,
                runWith(changed, "campaign @/plan.xml --out @/whole --resume"));
        assertEquals("broken: 0", runWith(jar, "campaign @/plan.xml --out @/a --shard 1/2"));
        assertEquals("broken: 0", runWith(changed, "campaign @/plan.xml --out @/b --shard 2/2"));
        assertEquals(
                "faultline: @/b: this is of another campaign than @/a, " + why,
                runWith(jar, "merge @/a @/b --out @/merged"));
        assertEquals(
                "faultline: the output \"@/copy.jar\" is an input or another output; expected another file"
                        + " (see faultline --help)",
                runWith(Files.copy(jar, folder.resolve("copy.jar")), "report @/whole --out @/copy.jar"));
    }

    /** Manifests of older versions have no such member either. */
    @Test
    void theManifestOfACampaignWithoutAJarNamesNone() throws IOException {
        Path plan = writePlan();
        Files.copy(Path.of("scenarios/yard.xml"), folder.resolve("yard.xml"), StandardCopyOption.REPLACE_EXISTING);
        Files.writeString(plan, Files.readString(plan).replaceAll("<set .*controller.*>", ""));
        String made =
                run("campaign", plan.toString(), "--out", folder.resolve("out").toString());
        assertTrue(made.endsWith("broken: 0\n"), made);
        assertFalse(Files.readString(folder.resolve("out/campaign.json")).contains("controllers"));
    }

    @Test
    void theTruthIsForControllersInChildProcesses() {
        String usage = "faultline: --truth needs --controller COMMAND (see faultline --help)\n";
        for (String name : List.of("my-follower", "wall-follower", "none")) {
            forgetJar();
            assertEquals(
                    usage, run("run", "scenarios/yard.xml", "--controller", name, "--jar", jar.toString(), "--truth"));
        }
    }

    @Test
    void aTestRunsTheExampleInAShippedScenario() throws Exception {
        String output = run("run", "scenarios/yard.xml", "--controller", "my-follower", "--jar", jar.toString());
        Scenario yard = Scenario.loadShipped("yard.xml");
        ControllerSpec mine = new ControllerSpec.Provided("my-follower", 0, Map.of());
        ScenarioRun run = yard.withSetup(yard.setup().withController(mine)).run();
        assertTrue(run.collision().isEmpty());
        assertEquals(value(output, "trajectory_hash"), run.trajectoryHash());
    }

    /** Returns a file that names the controller of the example. */
    private Path yardOfTheExample() throws IOException {
        return Files.writeString(
                folder.resolve("yard.xml"),
                Files.readString(Path.of("scenarios/yard.xml"))
                        .replace(
                                "</scenario>",
                                "<controller type=\"my-follower\"><setting name=\"distance\" value=\"0.35\"/>"
                                        + "</controller></scenario>"));
    }

    @Test
    void aFileThatNamesTheControllerIsCheckedWithTheJar() throws IOException {
        String file = yardOfTheExample().toString();
        List<String> problems = run("check", file).lines().toList();
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(
                problems.get(0).contains(": type of <controller> is \"my-follower\"; expected "), problems::toString);
        assertEquals(file + ": good\n", run("check", file, "--jar", jar.toString()));
    }

    @Test
    void theWindowOpensAFileThatNamesAControllerOfTheJar() throws Exception {
        String file = yardOfTheExample().toString();
        String expected = value(run("run", file, "--jar", jar.toString()), "trajectory_hash");
        // Without a display, the file is read and run.
        ProcessBuilder builder = JavaProcess.builder("faultline.app.Main", List.of(file, "--jar", jar.toString()));
        builder.command().add(1, "-Djava.awt.headless=true");
        assertEquals(expected, value(JavaProcess.output(builder.start()), "trajectory_hash"));
        builder.command().addAll(List.of("--controller", "my-follower"));
        String refusal = JavaProcess.output(builder.redirectErrorStream(true).start());
        assertEquals(
                "faultline: --controller needs a display here, and there is none (see faultline --help)\n", refusal);
    }

    @Test
    void aFileGivesTheExampleItsSettings() throws Exception {
        Path file = yardOfTheExample();
        String output = run("run", file.toString(), "--jar", jar.toString());
        assertEquals("none", value(output, "collision"));
        assertTrue(Double.parseDouble(value(output, "distance_rms_m")) > 0.08, "wanted are 0.25 m: " + output);
    }

    @Test
    void theExampleIsMeasuredByTheDistanceOfTheFile() throws Exception {
        Path file = yardOfTheExample();
        String plain = run("run", file.toString(), "--jar", jar.toString());
        Files.writeString(
                file, Files.readString(file).replace("\"my-follower\">", "\"my-follower\" distance=\"0.35\">"));
        String output = run("run", file.toString(), "--jar", jar.toString());
        assertEquals(value(plain, "trajectory_hash"), value(output, "trajectory_hash"));
        assertTrue(Double.parseDouble(value(output, "distance_rms_m")) < 0.04, output);
    }
}
