package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerProvider;
import faultline.control.ControllerSpec;
import faultline.control.Observation;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import faultline.sensor.Reading;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A controller as the child of another simulator, which may violate the protocol. */
class BuiltInChildTest {

    @TempDir
    private Path folder;

    /** The other simulator's greeting is ours with a replaced part; its observation follows. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            hello           | drive           |                                | wrote a message of type "drive"; expected hello, observe or end
            hello           | observe         |                                | wrote an observe message before the hello message
            "protocol":1    | "protocol":2    |                                | speaks protocol 2; expected 1
            "dt_s":0.01     | "dt_s":-0       |                                | has ticks of -0 s; expected more than 0
            "dt_s":0.01     | "dt_s":1e-9     |                                | has ticks of 0.000000001 s; expected from 0.00001 to 1 seconds
            "dt_s":0.01     | "dt_s":1.5      |                                | has ticks of 1.5 s; expected from 0.00001 to 1 seconds
            "dt_s":0.01     | "dt_s":{"a":[1,null,"x"]} |                      | wrote a message whose "dt_s" is the object {"a":[1,null,"x"]}; expected a finite number
            "robot":        | "robt":         |                                | wrote a message whose "robot" is missing; expected an object
            "width_m":0.2   | "width_m":-0.2  |                                | describes a robot that cannot be: its width_m is -0.2; expected from 0.000001 to 100000 metres
            "length_m":0.25 | "length_m":1e300 |                               | describes a robot that cannot be: its length_m is 1E+300; expected from 0.000001 to 100000 metres
            "track_m":0.18  | "track_m":1e-9  |                                | describes a robot that cannot be: its track_m is 0.000000001; expected from 0.000001 to 100000 metres
            "speed_m_s":0.3 | "speed_m_s":1001 |                               | describes a robot that cannot be: its speed_m_s is 1001; expected more than 0 and at most 1000 metres per second
            "bearing_rad":0,| "bearing_rad":-1e5, |                            | describes a robot that cannot be: its bearing_rad is -100000; expected from -17453.292519943298 to 17453.292519943298
            "range_m":0.8   | "range_m":1e12  |                                | describes a robot that cannot be: its range_m is 1000000000000; expected from 0.000001 to 100000 metres
            "front-left"    | "front"         |                                | describes a robot that cannot be: two sensors have the id front
            "protocol":1    | "protocol":1.0  | "readings_m":[],"answers":[]   | wrote an observe message with 0 readings and 0 answers; expected 8 of each, one for each sensor
            "protocol":1    | "protocol":1.0  | "readings_m":[1e999],"answers":[true] | wrote a message whose "readings_m" is the array [1e999]; expected an array of finite numbers
            "protocol":1    | "protocol":1.0  | "readings_m":[1],"answers":[1] | wrote a message whose "answers" is the array [1]; expected an array of true and false
            "protocol":1    | "protocol":1.0  | "readings_m":[1,1,1,1,1,1,1,1],"answers":[true] | wrote an observe message with 8 readings and 1 answers; expected 8 of each, one for each sensor
            "protocol":1    | "protocol":1.0  | "readings_m":[1],"answers":[true,true,true,true,true,true,true,true] | wrote an observe message with 1 readings and 8 answers; expected 8 of each, one for each sensor
            """)
    void aBadMessageEndsTheControllerInOneSentence(String part, String other, String readings, String sentence)
            throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        String hello = ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1));
        String observe = "{\"type\":\"observe\",\"tick\":0," + readings + "}";
        byte[] in = (hello.replace(part, other) + "\n" + observe + "\n").getBytes(StandardCharsets.UTF_8);
        BuiltInChild child = new BuiltInChild(new ByteArrayInputStream(in), new ByteArrayOutputStream());
        RunFailedException e = assertThrows(RunFailedException.class, () -> child.run(setup.controller()));
        assertEquals("the simulator " + sentence, e.getMessage());
    }

    /** The number of a tick that no run has would be counted up to, tick by tick. */
    @ParameterizedTest
    @CsvSource({
        "10000000, 20000001, -",
        "10000001, 0, a whole number from 0 to 10000000",
        "-1, 0, a whole number from 0 to 10000000",
        "7, 9007199254740991, a whole number from 8 to 10000008",
        "7, 7, a whole number from 8 to 10000008"
    })
    void ticksFollowEachOther(long first, long second, String expected) throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        String hello = ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1));
        String readings = ",\"readings_m\":[1,1,1,1,1,1,1,1],\"answers\":" + Collections.nCopies(8, true) + "}\n";
        String in = hello + "\n{\"type\":\"observe\",\"tick\":" + first + readings + "{\"type\":\"observe\",\"tick\":"
                + second + readings;
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BuiltInChild child = new BuiltInChild(new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)), out);
        if (expected.equals("-")) {
            child.run(setup.controller());
            assertTrue(out.toString(StandardCharsets.UTF_8).contains("\"tick\":" + second + ","), out::toString);
            return;
        }
        String failure = assertThrows(RunFailedException.class, () -> child.run(setup.controller()))
                .getMessage();
        assertTrue(failure.startsWith("the simulator wrote a message whose \"tick\" is the number "), failure);
        assertTrue(failure.endsWith("; expected " + expected), failure);
    }

    @Test
    void aReadingThatNoSensorHasIsRefused() throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        String hello = ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1));
        String observe = "{\"type\":\"observe\",\"tick\":0,\"readings_m\":[1,1,1,1,1,1,1,-1e300]" + ",\"answers\":"
                + Collections.nCopies(8, true) + "}";
        assertEquals(
                "the simulator wrote an observe message with a reading of -1E+300 m;"
                        + " expected from -1000000000 to 1000000000",
                failureOf((hello + "\n" + observe + "\n").getBytes(StandardCharsets.UTF_8)));
    }

    /** The wall ahead comes nearer, so that the follower turns, and is then away. */
    @Test
    void eachHelloBeginsARunThatKnowsNoOther() throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        StringBuilder run = new StringBuilder(ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1)));
        double[] readings = new double[setup.robot().sensors().size()];
        for (int tick = 0; tick < 250; tick++) {
            Arrays.fill(readings, tick == 0 ? Reading.NOTHING : 0.7 - 0.002 * tick);
            Observation observation = new Observation(tick, setup.dt(), setup.robot(), readings);
            run.append('\n').append(ProtocolMessages.observe(observation, false).finish());
        }
        byte[] in = (run + "\n").repeat(2).getBytes(StandardCharsets.UTF_8);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new BuiltInChild(new ByteArrayInputStream(in), out).run(setup.controller());
        List<String> answers = out.toString(StandardCharsets.UTF_8).lines().toList();
        assertEquals(502, answers.size());
        assertEquals(answers.subList(0, 251), answers.subList(251, 502));
        assertTrue(answers.get(250).contains("TURN"), answers.get(250));
    }

    /** The window shows the name, so it must not be that of a state. */
    @Test
    void aControllerGivesItselfTheNameOfItsType() throws Exception {
        assertEquals("wall-follower", nameOf(ControllerSpec.WallFollowing.DEFAULT));
        assertEquals("drive", nameOf(new ControllerSpec.Drive(1, 1)));
        assertEquals("none", nameOf(new ControllerSpec.None()));
    }

    private static String nameOf(ControllerSpec spec) throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        String hello = ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new BuiltInChild(new ByteArrayInputStream(hello.getBytes(StandardCharsets.UTF_8)), out).run(spec);
        return MessageReader.of(out.toString(StandardCharsets.UTF_8)).string("name");
    }

    @Test
    void aLineThatIsTooLongOrNotUtf8EndsTheController() {
        assertEquals(
                "the simulator wrote a line of more than 1000000 bytes; expected shorter ones",
                failureOf("x".repeat(2_000_000).getBytes(StandardCharsets.UTF_8)));
        assertEquals(
                "the simulator wrote a line that is not UTF-8: \"\uFFFD{}\"",
                failureOf(new byte[] {(byte) 0xFF, '{', '}', '\n'}));
    }

    private static String failureOf(byte[] in) {
        BuiltInChild child = new BuiltInChild(new ByteArrayInputStream(in), new ByteArrayOutputStream());
        return assertThrows(RunFailedException.class, () -> child.run(ControllerSpec.WallFollowing.DEFAULT))
                .getMessage();
    }

    @Test
    void eachAnswerIsSentBeforeTheNextMessageIsRead() throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        double[] readings = new double[setup.robot().sensors().size()];
        WaitingClient simulator = new WaitingClient(
                ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1)),
                ProtocolMessages.observe(new Observation(0, setup.dt(), setup.robot(), readings), false)
                        .finish());
        new BuiltInChild(simulator, simulator.answers()).run(setup.controller());
        assertEquals(List.of(0L, 1L, 2L), simulator.answersBefore());
    }

    private void run(Map<String, String> settings, int lastTick) throws Exception {
        run(settings, lastTick, 1);
    }

    /** Runs the child with a controller of a test against a simulator that sends observations up to a tick, in runs. */
    private void run(Map<String, String> settings, int lastTick, int runs) throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        StringBuilder in = new StringBuilder(ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1)));
        double[] readings = new double[setup.robot().sensors().size()];
        for (int tick = 0; tick <= lastTick; tick++) {
            Observation observation = new Observation(tick, setup.dt(), setup.robot(), readings);
            in.append('\n').append(ProtocolMessages.observe(observation, false).finish());
        }
        byte[] all = (in + "\n").repeat(runs).getBytes(StandardCharsets.UTF_8);
        BuiltInChild child = new BuiltInChild(new ByteArrayInputStream(all), new ByteArrayOutputStream());
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(services.resolve(ControllerProvider.class.getName()), RightTurner.class.getName());
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
            thread.setContextClassLoader(loader);
            child.run(new ControllerSpec.Provided("right-turner", setup.dt(), settings));
        } finally {
            thread.setContextClassLoader(before);
        }
    }

    @Test
    void aControllerIsClosedAtTheEnd() throws Exception {
        int before = RightTurner.CLOSED.get();
        run(Map.of(), 3);
        assertEquals(before + 1, RightTurner.CLOSED.get());
        run(Map.of(), 3, 2);
        assertEquals(before + 3, RightTurner.CLOSED.get());
    }

    @Test
    void aControllerThatCannotBeClosedIsReported() {
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(Map.of("deed", "close"), 3));
        assertEquals("the controller cannot be closed: java.io.IOException: still in use", e.getMessage());
    }

    @Test
    void aControllerThatThrowsIsClosedAndNamedWithItsTick() {
        int before = RightTurner.CLOSED.get();
        RunFailedException e = assertThrows(RunFailedException.class, () -> run(Map.of("deed", "error"), 9));
        assertEquals("the controller broke at tick 7: java.lang.StackOverflowError: too deep", e.getMessage());
        assertEquals(before + 1, RightTurner.CLOSED.get());
    }
}
