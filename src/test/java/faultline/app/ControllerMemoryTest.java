package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.SamplePlan;
import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A controller in Java that asks for more memory than there can be is named with its tick. */
class ControllerMemoryTest {

    private static final String NAME = "hoarder";
    private static final String BROKE =
            "the controller broke at tick 7: java.lang.OutOfMemoryError: Requested array size exceeds VM limit";

    @TempDir
    private Path folder;

    private final ClassLoader before = Thread.currentThread().getContextClassLoader();
    private URLClassLoader loader;

    /** Asks for an array of the greatest length, which no virtual machine has: at tick 7, or when it is created. */
    public static final class Hoarder implements ControllerProvider {
        @Override
        public String name() {
            return NAME;
        }

        @Override
        public Controller create(Map<String, String> settings) {
            if (settings.containsKey("early")) {
                hoard();
            }
            return settings.containsKey("last") ? new LateHoarder() : Hoarder::decide;
        }

        private static Decision decide(Observation observation) {
            double volts = observation.tick() == 7 ? hoard() : 1;
            return new Decision(volts, volts, Telemetry.ofState(ControllerState.of("GO")));
        }

        private static int hoard() {
            return new int[Integer.MAX_VALUE].length;
        }
    }

    /** Asks for such an array when it is closed. */
    private static final class LateHoarder implements Controller, AutoCloseable {
        @Override
        public Decision decide(Observation observation) {
            return Hoarder.decide(observation);
        }

        @Override
        public void close() {
            Hoarder.hoard();
        }
    }

    @BeforeEach
    void findProvider() throws Exception {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(services.resolve(ControllerProvider.class.getName()), Hoarder.class.getName());
        loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before);
        Thread.currentThread().setContextClassLoader(loader);
    }

    @AfterEach
    void forgetProvider() throws Exception {
        Thread.currentThread().setContextClassLoader(before);
        loader.close();
    }

    private static String fail(String... arguments) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PrintStream discarded = new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8);
        CommandOutput output = new CommandOutput(discarded, new PrintStream(err, true, StandardCharsets.UTF_8));
        assertEquals(ExitCode.RUN_FAILED, new CommandLine(output).run(arguments));
        return err.toString(StandardCharsets.UTF_8);
    }

    private Path scenario(String setting) throws Exception {
        Path file = folder.resolve("room.xml");
        Files.writeString(
                file,
                SamplePlan.ROOM.replace(
                        "</scenario>",
                        "<controller type=\"" + NAME + "\"><setting name=\"" + setting
                                + "\" value=\"1\"/></controller></scenario>"));
        return file;
    }

    @Test
    void aRunNamesTheControllerAndTheTick() throws Exception {
        assertEquals(
                "faultline: the run broke: " + BROKE + "\n",
                fail("run", scenario("late").toString()));
    }

    @Test
    void aControllerThatCannotBeCreatedIsNamed() throws Exception {
        String text = fail("run", scenario("early").toString());
        assertTrue(
                text.startsWith("faultline: the run broke: the controller \"" + NAME
                        + "\" cannot be created: java.lang.OutOfMemoryError: "),
                text);
    }

    @Test
    void aControllerThatCannotBeClosedIsNamed() throws Exception {
        assertEquals(
                "faultline: the run broke: the controller cannot be closed: "
                        + "java.lang.OutOfMemoryError: Requested array size exceeds VM limit\n",
                fail("run", scenario("last").toString(), "--until", "0.05"));
    }

    @Test
    void aComparisonContinuesWithTheNextController() {
        Path page = folder.resolve("page.html");
        String text = fail(
                "compare",
                "scenarios/yard.xml",
                "--controller",
                NAME,
                "--controller",
                "none",
                "--until",
                "1",
                "--out",
                page.toString());
        assertTrue(text.contains("broke: " + BROKE + "\n"), text);
        assertTrue(Files.exists(page));
    }

    @Test
    void aCampaignNamesTheControllerAndTheTick() throws Exception {
        scenario("late");
        Path plan = folder.resolve("plan.xml");
        Files.writeString(plan, SamplePlan.text("", "<worlds><scenario file=\"room.xml\"/></worlds>"));
        assertEquals(
                "faultline: the run broke: " + BROKE + "\n",
                fail(
                        "campaign",
                        plan.toString(),
                        "--out",
                        folder.resolve("results").toString()));
    }
}
