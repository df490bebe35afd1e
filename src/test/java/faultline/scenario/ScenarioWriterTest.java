package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape.PlanShape;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that are written, and what reading them gives. */
class ScenarioWriterTest {

    @TempDir
    private Path folder;

    @Test
    void whateverAScenarioHoldsReadsBackEqual() throws ScenarioException {
        for (int seed = 0; seed < 500; seed++) {
            Scenario scenario = new RandomScenarios(seed).next();
            assertEquals(
                    scenario, SampleScenario.read(ScenarioWriter.toText(scenario, XmlComments.NONE)), "seed " + seed);
        }
    }

    /** A campaign writes up to twenty files with the same floor plan. */
    @Test
    void aPlanOfManyPointsIsWrittenWithoutManyObjects() {
        List<Vector2> ring = List.of(new Vector2(0.05, 0.1), new Vector2(1.25, 0), new Vector2(7, 12.35));
        PlanShape plan = new PlanShape(Collections.nCopies(5000, ring));
        Obstacle obstacle = new Obstacle("plan", plan, new Pose(0, 0, 0));
        Scenario scenario = new Scenario(
                "Plan",
                "",
                false,
                SimulationSetup.of(new WorldSpec(20, 20, true, 0, List.of(obstacle)), new Pose(15, 15, 0)),
                Expectation.NONE);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        // The first writing also loads classes, unless another test has.
        int length = ScenarioWriter.toText(scenario, XmlComments.NONE).length();
        long before = threads.getCurrentThreadAllocatedBytes();
        ScenarioWriter.toText(scenario, XmlComments.NONE);
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(bytes < 40L * length, bytes + " bytes for " + length + " characters");
    }

    @Test
    void aWrittenFileIsIndentedAndInAStableOrder() throws ScenarioException {
        Scenario scenario = SampleScenario.read(
                """
                <scenario xmlns="urn:faultline:scenario:1" name="A &lt; B"><robot y="2" x="1"><sensor cone="30" id="left"/></robot>
                <world height="4" width="6"><wall id="w" points="3,1 3,2" y="0" x="0"/></world><expect collision="true" states="FOLLOW SEARCH"/>
                <timeline><fault at="1" until="2.5" sensor="left" kind="off"/></timeline></scenario>
                """);
        assertEquals(
                """
                <?xml version="1.0" encoding="UTF-8"?>
                <scenario xmlns="urn:faultline:scenario:1" name="A &lt; B" duration="120" tick="0.01" seed="1">
                  <world width="6" height="4" enclosed="true" maxMoving="3">
                    <wall id="w" x="0" y="0" heading="0" points="3,1 3,2"/>
                  </world>
                  <robot x="1" y="2" heading="0" length="0.25" width="0.2" track="0.18" speed="0.3" turnRate="60" defaultSensors="true">
                    <motor timeConstant="0.05" speedConstant="0.1" maxVoltage="6"/>
                    <sensor id="left" x="0" y="0.1" bearing="90" range="0.8" cone="30" on="true" noise="0"/>
                  </robot>
                  <controller type="wall-follower" distance="0.25" hand="left" period="0" timing="equal-readings"/>
                  <timeline>
                    <fault at="1" sensor="left" kind="off" until="2.5"/>
                  </timeline>
                  <expect collision="true" states="FOLLOW SEARCH"/>
                </scenario>
                """,
                ScenarioWriter.toText(scenario, XmlComments.NONE));
    }

    /** A fault is written with its end only if the next command is its end. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "<fault at=\"1\" sensor=\"left\" kind=\"off\" until=\"3\"/>",
                "<fault at=\"1\" motor=\"left\" kind=\"weak\" value=\"0.5\" until=\"3\"/>",
                "<fault at=\"1\" motor=\"left\" kind=\"dead\"/>\n    <mend at=\"1\" motor=\"left\" kind=\"dead\"/>\n"
                        + "    <mend at=\"2\" motor=\"left\"/>",
                "<fault at=\"1\" sensor=\"left\" kind=\"off\"/>\n    <switch at=\"2\" sensor=\"rear\" on=\"false\"/>\n"
                        + "    <mend at=\"3\" sensor=\"left\" kind=\"off\"/>",
                "<fault at=\"1\" sensor=\"left\" kind=\"off\"/>\n    <mend at=\"1\" sensor=\"left\" kind=\"off\"/>",
                "<fault at=\"1\" sensor=\"left\" kind=\"off\"/>\n    <mend at=\"3\" sensor=\"right\" kind=\"off\"/>"
            })
    void aTimelineIsWrittenAsItWasRead(String commands) throws ScenarioException {
        Scenario scenario = SampleScenario.read(
                """
                <scenario xmlns="urn:faultline:scenario:1"><world width="6" height="4"/><robot x="1" y="2"/>
                <timeline>%s</timeline></scenario>
                """
                        .formatted(commands));
        String written = ScenarioWriter.toText(scenario, XmlComments.NONE);
        assertTrue(written.contains("<timeline>\n    " + commands + "\n  </timeline>"), written);
    }

    /** The first is the longest possible; the decisions of the second are beyond its end. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "ticks=\"9007199254740992\"><decisions>1,1</decisions><decisions from=\"9007199254740991\""
                        + " state=\"LAST\">2,2</decisions>",
                "ticks=\"1\"><decisions from=\"4\">1,1*3 2,2</decisions>"
            })
    void aRecordIsSavedAndReadBackEqual(String record) throws Exception {
        Scenario scenario = SampleScenario.read(SampleScenario.withReplacement(
                "<controller type=\"wall-follower\" distance=\"0.25\"/>",
                "<controller type=\"recorded\" " + record + "</controller>"));
        assertEquals(scenario, SampleScenario.read(new String(scenario.toBytes(), StandardCharsets.UTF_8)));
    }

    @Test
    void theSettingsOfAControllerAreInTheOrderOfTheirNames() throws ScenarioException {
        Map<String, String> settings = new HashMap<>();
        for (String name : "wall kp speed ahead side mode limit margin".split(" ")) {
            settings.put(name, "1");
        }
        Scenario room = SampleScenario.read(SampleScenario.PLAIN);
        SimulationSetup setup = room.setup().withController(new ControllerSpec.Provided("own", 0, settings));
        String text = ScenarioWriter.toText(room.withSetup(setup), XmlComments.NONE);
        assertEquals(
                List.of("ahead", "kp", "limit", "margin", "mode", "side", "speed", "wall"),
                Pattern.compile("<setting name=\"(.*?)\"")
                        .matcher(text)
                        .results()
                        .map(found -> found.group(1))
                        .toList());
    }

    @Test
    void theDistanceOfAControllerFromOutsideIsSavedIfItIsNotTheDefault() throws Exception {
        String plain = "<controller type=\"wall-follower\" distance=\"0.25\"/>";
        String far = "<controller type=\"extern\" distance=\"0.3\"/>";
        Scenario scenario = SampleScenario.read(SampleScenario.withReplacement(plain, far));
        assertEquals(scenario, SampleScenario.read(new String(scenario.toBytes(), StandardCharsets.UTF_8)));
        String usual = "<controller type=\"extern\" period=\"0\"/>";
        String saved = new String(
                SampleScenario.read(SampleScenario.withReplacement(plain, usual))
                        .toBytes(),
                StandardCharsets.UTF_8);
        assertTrue(saved.contains(usual), saved);
    }

    @Test
    void savingLeavesTheFileAndNothingElse() throws Exception {
        Scenario scenario = SampleScenario.read(SampleScenario.PLAIN);
        Path file = folder.resolve("room.xml");
        Files.writeString(file, "what was there before");
        scenario.save(file);
        assertEquals(scenario, Scenario.load(file));
        assertEquals(List.of(file), filesInFolder());
    }

    @Test
    void aScenarioThatNoFileMayHoldIsNotSavedAndTheOldFileStays() throws Exception {
        Scenario plain = SampleScenario.read(SampleScenario.PLAIN);
        SimulationSetup setup = plain.setup();
        WorldSpec vast = new WorldSpec(1e6, 1, true, 3, List.of());
        Scenario bad = plain.withSetup(SimulationSetup.of(vast, setup.start())
                .withRobot(setup.robot())
                .withController(setup.controller())
                .withDuration(1));
        Path file = folder.resolve("room.xml");
        Files.writeString(file, "what was there before");
        IOException refusal = assertThrows(IOException.class, () -> bad.save(file));
        assertEquals(
                "the scenario cannot be saved: width of <world> is \"1000000\"; expected a number "
                        + "from 0.000001 to 100000 metres",
                refusal.getMessage());
        assertEquals("what was there before", Files.readString(file));
    }

    /** The journal of a long run with another controller has its decisions. */
    @Test
    void aScenarioThatIsTooLargeToBeReadIsNotSaved() throws Exception {
        Scenario plain = SampleScenario.read(SampleScenario.PLAIN);
        Scenario large = new Scenario("large", "x".repeat(16 << 20), false, plain.setup(), plain.expectation());
        Path file = folder.resolve("large.xml");
        IOException refusal = assertThrows(IOException.class, () -> large.save(file));
        assertEquals(
                "the scenario cannot be saved: the file has 16.1 MiB; expected at most 16 MiB", refusal.getMessage());
        assertFalse(Files.exists(file));
    }

    @Test
    void aMissingFolderIsReportedInOneLine() throws ScenarioException {
        Scenario scenario = SampleScenario.read(SampleScenario.PLAIN);
        Path file = folder.resolve("none").resolve("room.xml");
        IOException refusal = assertThrows(IOException.class, () -> scenario.save(file));
        assertEquals(file + ": its folder does not exist", refusal.getMessage());
        assertFalse(Files.exists(file));
    }

    private List<Path> filesInFolder() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }
}
