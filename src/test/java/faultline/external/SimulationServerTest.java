package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.robot.DriveScale;
import faultline.robot.Velocity;
import faultline.scenario.Scenario;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Requests in, observations out. */
class SimulationServerTest {

    @TempDir
    private Path folder;

    private static List<String> serve(String... requests) throws Exception {
        return serveText(String.join("\n", requests) + "\n");
    }

    private static List<String> serveText(String requests) throws Exception {
        return serveText(office(), requests);
    }

    private static List<String> serveText(SimulationSetup setup, String requests) throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] in = requests.getBytes(StandardCharsets.UTF_8);
        new SimulationServer("faultline test", "Office", true, new ByteArrayInputStream(in), out)
                .run(setup, () -> false);
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private static SimulationSetup office() throws Exception {
        return Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(1);
    }

    @Test
    void theDocumentedExchangeIsTheOneOfTheProgram() throws Exception {
        String page = Files.readString(Path.of("docs/controllers.md"));
        Path eye = Files.writeString(folder.resolve("eye.xml"), block(page, "xml", "<scenario [^>]*name=\"Eye\""));
        List<String> lines = block(page, "text", "\\{\"type\":\"hello\"")
                .replaceAll("\n {4}", "")
                .lines()
                .toList();
        String requests = lines.stream()
                .filter(line -> line.startsWith("> "))
                .map(line -> line.substring(2) + "\n")
                .collect(Collectors.joining());
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] in = requests.getBytes(StandardCharsets.UTF_8);
        new SimulationServer("faultline 0.1.0", "Eye", false, new ByteArrayInputStream(in), out)
                .run(Scenario.load(eye).setup(), () -> false);
        assertEquals(
                lines.stream().filter(line -> !line.startsWith("> ")).toList(),
                out.toString(StandardCharsets.UTF_8).lines().toList());
    }

    private static String block(String page, String language, String start) {
        Matcher block = Pattern.compile("(?s)```" + language + "\n(" + start + ".*?)```")
                .matcher(page);
        assertTrue(block.find(), start);
        return block.group(1);
    }

    @Test
    void aMemberThatIsNullCountsAsMissing() throws Exception {
        assertEquals(
                serve("{\"type\":\"reset\"}", "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1}"),
                serve(
                        "{\"type\":\"reset\",\"seed\":null}",
                        "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1,\"ticks\":null,\"v_m_s\":null}"));
    }

    @Test
    void everyRequestHasOneAnswerBehindTheGreeting() throws Exception {
        List<String> answers = serve(
                "{\"type\":\"reset\",\"seed\":7}",
                "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1,\"ticks\":5}",
                "{\"type\":\"drive\",\"v_m_s\":0.1,\"omega_rad_s\":0,\"ticks\":1}",
                "{\"type\":\"close\"}");
        assertEquals(4, answers.size());
        assertTrue(answers.get(0).startsWith("{\"type\":\"hello\",\"protocol\":1,"), answers.get(0));
        assertTrue(answers.get(1).contains("\"tick\":0,"), answers.get(1));
        assertTrue(answers.get(2).contains("\"tick\":5,"), answers.get(2));
        assertTrue(answers.get(3).contains("\"tick\":6,"), answers.get(3));
        assertTrue(answers.get(3).contains("\"truth\":{\"pose\":{"), answers.get(3));
    }

    @Test
    void eachAnswerIsSentBeforeTheNextRequestIsRead() throws Exception {
        String drive = "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1}";
        WaitingClient client = new WaitingClient("{\"type\":\"reset\"}", drive, drive);
        new SimulationServer("faultline test", "Office", false, client, client.answers()).run(office(), () -> false);
        assertEquals(List.of(1L, 2L, 3L, 4L), client.answersBefore());
    }

    @Test
    void aRequestBehindTheCloseIsNotAnswered() throws Exception {
        assertEquals(1, serve("{\"type\":\"close\"}", "{\"type\":\"reset\"}").size());
    }

    @Test
    void drivingConstantlyGivesTheTrajectoryOfTheDriveController() throws Exception {
        SimulationSetup setup = office();
        SimulationSetup constant = setup.withController(new ControllerSpec.Drive(2.5, 3));
        long expected =
                HeadlessRun.run(constant, ControllerMode.DIRECT, List.of()).trajectoryHash();
        List<String> answers = serve("{\"type\":\"drive\",\"left_v\":2.5,\"right_v\":3,\"ticks\":1000}");
        String end = answers.get(1);
        assertTrue(end.startsWith("{\"type\":\"end\",\"reason\":\"duration\""), end);
        assertTrue(end.contains("\"summary\":{\"truth\":\"given to the controller\"}"), end);
        assertTrue(end.contains(String.format(Locale.ROOT, "\"trajectory_hash\":\"%016x\"", expected)), end);
    }

    /** The client learns the robot that a controller believes in, as it does as a controller. */
    @Test
    void aRobotWithADriveScaleIsDescribedWithoutIt() throws Exception {
        SimulationSetup office = office();
        SimulationSetup uneven = office.withRobot(office.robot().withDriveScale(new DriveScale(0.95, 1, 1.2)));
        String requests =
                "{\"type\":\"reset\"}\n{\"type\":\"drive\",\"v_m_s\":0.2,\"omega_rad_s\":0.1,\"ticks\":1000}\n";
        List<String> expected = serveText(office, requests);
        List<String> answers = serveText(uneven, requests);
        assertEquals(expected.subList(0, 2), answers.subList(0, 2));
        Decision decision = Decision.ofVelocity(office.robot(), new Velocity(0.2, 0.1), "", "");
        SimulationSetup constant =
                uneven.withController(new ControllerSpec.Drive(decision.leftVolts(), decision.rightVolts()));
        long hash = HeadlessRun.run(constant, ControllerMode.DIRECT, List.of()).trajectoryHash();
        String end = answers.get(2);
        assertTrue(end.contains(String.format(Locale.ROOT, "\"trajectory_hash\":\"%016x\"", hash)), end);
        assertNotEquals(expected.get(2), end);
    }

    @Test
    void aLastLineWithoutABreakCountsAsARequest() throws Exception {
        assertEquals(2, serveText("{\"type\":\"reset\"}\n{\"type\":\"close\"}").size());
        RunFailedException half = assertThrows(RunFailedException.class, () -> serveText("{\"type\":\"res"));
        assertTrue(half.getMessage().startsWith("the client wrote no JSON at tick 0: "), half.getMessage());
    }

    @Test
    void aResetGivesTheSameRunAgain() throws Exception {
        String drive = "{\"type\":\"drive\",\"left_v\":2,\"right_v\":3,\"ticks\":50}";
        List<String> answers = serve(drive, "{\"type\":\"reset\"}", drive);
        assertEquals(answers.get(1), answers.get(3));
    }

    /** The range is 0.4 m from tick 2 on and 0.8 m from tick 4 on, as at the start; the last tick changes it again. */
    @Test
    void aRobotThatIsChangedBackIsToldToo() throws Exception {
        SimulationSetup setup = Scenario.load(
                        Files.writeString(
                                folder.resolve("tuned.xml"),
                                """
                        <scenario xmlns="urn:faultline:scenario:1" duration="0.06">
                          <world width="6" height="4"/>
                          <robot x="3" y="2"/>
                          <timeline>
                            <tune at="0.02" sensor="left" range="0.4"/>
                            <tune at="0.04" sensor="left" range="0.8"/>
                            <tune at="0.06" sensor="left" range="0.3"/>
                          </timeline>
                        </scenario>
                        """))
                .setup();
        String drive = "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1}\n";
        List<String> answers = serveText(setup, drive.repeat(6) + "{\"type\":\"reset\"}\n{\"type\":\"reset\"}\n");
        List<String> ranges =
                answers.stream().skip(1).map(SimulationServerTest::leftRange).toList();
        assertEquals(List.of("", "0.4", "", "0.8", "", "0.3", "0.8", ""), ranges);
    }

    /** Returns the range of the left sensor if a message describes the robot. */
    private static String leftRange(String message) {
        Matcher range =
                Pattern.compile("\"id\":\"left\".*?\"range_m\":([0-9.]+)").matcher(message);
        return range.find() ? range.group(1) : "";
    }

    @Test
    void aSeedThatADoubleWouldRoundIsUsedAsItIs() throws Exception {
        long seed = (1L << 53) + 1;
        SimulationSetup noisy =
                Scenario.load(Path.of("scenarios/noisy-sensors.xml")).setup().withDuration(8);
        List<String> hashes = new ArrayList<>();
        for (long each : List.of(seed, seed - 1)) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            String requests = "{\"type\":\"reset\",\"seed\":" + each
                    + "}\n{\"type\":\"drive\",\"left_v\":3,\"right_v\":3,\"ticks\":1000}\n";
            new SimulationServer(
                            "faultline test",
                            "Noisy",
                            false,
                            new ByteArrayInputStream(requests.getBytes(StandardCharsets.UTF_8)),
                            out)
                    .run(noisy, () -> false);
            String end = out.toString(StandardCharsets.UTF_8);
            hashes.add(end.substring(end.lastIndexOf("readings_m")));
        }
        assertNotEquals(hashes.get(0), hashes.get(1));
    }

    @Test
    void aLineThatIsNotUtf8EndsTheServerInOneSentence() {
        byte[] latin1 = "{\"type\":\"reset\",\"who\":\"Ren\u00e9\"}\n".getBytes(StandardCharsets.ISO_8859_1);
        RunFailedException e = assertThrows(RunFailedException.class, () -> new SimulationServer(
                        "faultline test",
                        "Office",
                        false,
                        new ByteArrayInputStream(latin1),
                        new ByteArrayOutputStream())
                .run(office(), () -> false));
        assertEquals(
                "the client wrote a line at tick 0 that is not UTF-8: \"{\"type\":\"reset\",\"who\":\"Ren\uFFFD\"}\"",
                e.getMessage());
    }

    @Test
    void nothingIsReadAfterAClientThatHasClosedItsInput() throws Exception {
        PrintStream closed = new PrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("broken pipe");
            }
        });
        ByteArrayInputStream in = new ByteArrayInputStream("garbage\n".getBytes(StandardCharsets.UTF_8));
        new SimulationServer("faultline test", "Office", false, in, closed).run(office(), () -> false);
        assertTrue(closed.checkError());
        assertEquals(8, in.available());
    }

    @Test
    void noRequestIsAnsweredAfterAnAnswerThatCannotBeWritten() throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream closedAfterTheGreeting = new PrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                if (out.toString(StandardCharsets.UTF_8).endsWith("\n")) {
                    throw new IOException("broken pipe");
                }
                out.write(b);
            }
        });
        byte[] in = "{\"type\":\"reset\"}\ngarbage\n".getBytes(StandardCharsets.UTF_8);
        new SimulationServer("faultline test", "Office", false, new ByteArrayInputStream(in), closedAfterTheGreeting)
                .run(office(), () -> false);
        assertEquals(1, out.toString(StandardCharsets.UTF_8).lines().count());
    }

    @Test
    void theMostTicksOfADriveEndTheRunAfterWhichOnlyAResetIsAllowed() throws Exception {
        String drive = "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1,\"ticks\":1000000000}";
        List<String> answers = serve(drive, "{\"type\":\"reset\"}", drive);
        assertTrue(answers.get(1).startsWith("{\"type\":\"end\""), answers.get(1));
        assertEquals(answers.get(1), answers.get(3));
        RunFailedException e = assertThrows(RunFailedException.class, () -> serve(drive, drive));
        assertEquals(
                "the client wrote a drive message at tick 100 after the end of the run; expected reset or close",
                e.getMessage());
    }

    @Test
    void aReplacementCharacterInALineIsAllowed() throws Exception {
        assertEquals(2, serve("{\"type\":\"reset\",\"who\":\"\uFFFD\"}").size());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            {"type":"jump"}                                    | the client wrote a message at tick 0 of type "jump"; expected reset, drive or close
            {"type":"drive","left_v":1,"right_v":1,"ticks":0}  | the client wrote a message at tick 0 whose "ticks" is the number 0; expected a whole number from 1 to 1000000000
            {"type":"drive","left_v":1,"right_v":1,"ticks":1.5} | the client wrote a message at tick 0 whose "ticks" is the number 1.5; expected a whole number from 1 to 1000000000
            {"type":"drive","left_v":1,"right_v":1,"ticks":1e300} | the client wrote a message at tick 0 whose "ticks" is the number 1E+300; expected a whole number from 1 to 1000000000
            {"type":"drive","left_v":1,"right_v":1,"ticks":1000000001} | the client wrote a message at tick 0 whose "ticks" is the number 1000000001; expected a whole number from 1 to 1000000000
            {"type":"drive","left_v":1}                        | the client wrote a message at tick 0 whose "right_v" is missing; expected a finite number
            {"type":"drive","left_v":1,"right_v":1,"state":4}  | the client wrote a message at tick 0 whose "state" is the number 4; expected a string
            {"type":"drive","left_v":1,"right_v":1,"why":true} | the client wrote a message at tick 0 whose "why" is true; expected a string
            {"type":"drive","left_v":null,"right_v":[]}        | the client wrote a message at tick 0 whose "left_v" is null; expected a finite number
            {"type":"reset","seed":"7"}                        | the client wrote a message at tick 0 whose "seed" is the string "7"; expected a whole number
            {"type":"reset","seed":1.5}                        | the client wrote a message at tick 0 whose "seed" is the number 1.5; expected a whole number
            {"type":"reset","seed":9223372036854775808}        | the client wrote a message at tick 0 whose "seed" is the number 9223372036854775808; expected a whole number from -9223372036854775808 to 9223372036854775807, without point and exponent if it has more than 15 digits
            {"type":"reset","seed":9007199254740992.0}         | the client wrote a message at tick 0 whose "seed" is the number 9007199254740992; expected a whole number from -9223372036854775808 to 9223372036854775807, without point and exponent if it has more than 15 digits
            {"type":"reset","seed":1e16}                       | the client wrote a message at tick 0 whose "seed" is the number 1E+16; expected a whole number from -9223372036854775808 to 9223372036854775807, without point and exponent if it has more than 15 digits
            {"type":"drive","tick":99,"left_v":1,"right_v":1}  | the client answered tick 99 at tick 0; expected the tick of the observation
            {"type":"drive","tick":"0","left_v":1,"right_v":1} | the client wrote a message at tick 0 whose "tick" is the string "0"; expected a whole number
            hello                                              | the client wrote no JSON at tick 0: "hello" (there is no value at character 1); write messages for people to standard error
            """)
    void aBadRequestEndsTheServerInOneSentence(String request, String sentence) {
        RunFailedException e = assertThrows(RunFailedException.class, () -> serve(request));
        assertEquals(sentence, e.getMessage());
    }

    @Test
    void aDriveMayHaveTheTickOfTheLastObservation() throws Exception {
        String reset = "{\"type\":\"reset\"}";
        String drive = "{\"type\":\"drive\",\"left_v\":1,\"right_v\":1,\"ticks\":5%s}";
        assertEquals(
                serve(drive.formatted(""), drive.formatted(""), reset, drive.formatted("")),
                serve(
                        drive.formatted(",\"tick\":0"),
                        drive.formatted(",\"tick\":5.0"),
                        reset,
                        drive.formatted(",\"tick\":0")));
    }

    private static List<String> serveLongStep(boolean isClientGone) throws Exception {
        SimulationSetup setup = office().withDuration(isClientGone ? 1e7 : 3000);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] in = "{\"type\":\"drive\",\"left_v\":0,\"right_v\":0,\"ticks\":1000000000}\n"
                .getBytes(StandardCharsets.UTF_8);
        new SimulationServer("faultline test", "Office", false, new ByteArrayInputStream(in), out)
                .run(setup, () -> isClientGone);
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    @Timeout(60)
    void aStepWhoseAnswerNobodyReadsEndsTheServer() throws Exception {
        assertEquals(1, serveLongStep(true).size());
    }

    @Test
    void aClientThatOnlyClosesItsOutputGetsItsAnswer() throws Exception {
        List<String> answers = serveLongStep(false);
        assertTrue(answers.get(1).startsWith("{\"type\":\"end\",\"reason\":\"duration\""), answers.get(1));
    }
}
