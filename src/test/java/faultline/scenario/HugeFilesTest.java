package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.JavaProcess;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Files of up to 16 MB that are made to be slow: each is checked within 10 seconds of processor time and 512 MB. */
class HugeFilesTest {

    private static final double MAX_SECONDS = 10;
    private static final String ROBOT = "<robot x=\"1\" y=\"1\"/>";

    private static String repeat(int count, IntFunction<String> element) {
        return IntStream.range(0, count).mapToObj(element).collect(Collectors.joining());
    }

    private static String scenario(String world, String robot, String timeline) {
        return "<scenario xmlns=\"urn:faultline:scenario:1\"><world width=\"60\" height=\"40\">" + world + "</world>"
                + robot + (timeline.isEmpty() ? "" : "<timeline>" + timeline + "</timeline>") + "</scenario>";
    }

    private static String unknownIds() {
        String x = "x".repeat(40);
        return scenario(
                repeat(70_000, i -> "<circle id=\"" + x + "c" + i + "\" x=\"3\" y=\"3\" radius=\"0.1\"/>"),
                ROBOT,
                repeat(70_000, i -> "<remove at=\"1\" obstacle=\"" + x + "d" + i + "\"/>"));
    }

    private static String wrongAttributes() {
        return scenario(repeat(290_000, i -> "<circle id=\"c" + i + "\" z=\"" + i + "\"/>"), ROBOT, "");
    }

    /** Returns a file of controllers with many unknown attributes whose names resemble known ones. */
    private static String unknownAttributes(String at) {
        String names = repeat(9980, i -> " turnAngle" + i + "=\"\"");
        return scenario("", ROBOT, repeat(98, i -> "<controller" + at + names + "/>"));
    }

    /** Returns a file of many attributes of another namespace, which has a long name. */
    private static String foreignAttributes() {
        String names = repeat(9900, i -> " xsi:" + (char) ('a' + i % 26) + Integer.toString(i / 26, 36) + "=\"\"");
        String text = scenario(repeat(140, i -> "<rectangle" + names + "/>"), ROBOT, "");
        return text.replaceFirst(">", " xmlns:xsi=\"" + "x".repeat(980) + "\">");
    }

    private static String sensors(int count) {
        return scenario(
                "",
                "<robot x=\"1\" y=\"1\">"
                        + repeat(count, i -> "<sensor id=\"s" + i + "\" x=\"0\" y=\"0\" bearing=\"0\"/>") + "</robot>",
                "");
    }

    private static String wrongFaults() {
        return scenario(
                "",
                ROBOT,
                repeat(190_000, i -> "<fault at=\"" + i + "\" sensor=\"frnt\" kind=\"stuckk\" value=\"x\"/>"));
    }

    private static String puts() {
        return scenario(
                "",
                ROBOT,
                repeat(99_000, i -> "<put at=\"1\"><circle id=\"p" + i + "\" x=\"3\" y=\"3\" radius=\"0.1\"/></put>"));
    }

    /** Returns the problems of a file, of which no more than a hundred are listed. */
    private static List<Problem> problemsOf(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        assertTrue(bytes.length <= ScenarioLimits.MAX_BYTES, bytes.length + " bytes");
        CpuTime time = CpuTime.start();
        List<Problem> problems = List.of();
        try {
            ScenarioReader.read("file.xml", bytes);
        } catch (ScenarioException e) {
            problems = e.problems();
        }
        time.assertBelow(MAX_SECONDS);
        assertTrue(problems.size() <= Problems.MAX_LISTED + 1, problems.size() + " problems");
        return problems;
    }

    /** Checks all files; the test runs it in a separate process with limited memory. */
    static final class FileCheck {

        private FileCheck() {}

        public static void main(String[] args) {
            assertEquals(
                    "file.xml: more problems: 69900",
                    problemsOf(unknownIds()).get(Problems.MAX_LISTED).toString());
            assertEquals(Problems.MAX_LISTED + 1, problemsOf(wrongAttributes()).size());
            assertEquals(
                    "file.xml: more problems: 977940",
                    problemsOf(unknownAttributes(" at=\"1\""))
                            .get(Problems.MAX_LISTED)
                            .toString());
            assertEquals(
                    "file.xml: more problems: 978038",
                    problemsOf(unknownAttributes("")).get(Problems.MAX_LISTED).toString());
            assertTrue(problemsOf(foreignAttributes()).get(0).toString().contains("no attribute \"xsi:a0 xmlns="));
            assertEquals(Problems.MAX_LISTED + 1, problemsOf(wrongFaults()).size());
            assertEquals(
                    "<robot> has too many sensors; expected at most 1008",
                    problemsOf(sensors(250_000)).get(0).message().toString());
            assertEquals(List.of(), problemsOf(puts()));
            System.out.println("checked");
        }
    }

    @Test
    void everyFileIsCheckedInTimeAndInHalfAGigabyte() throws Exception {
        Process process = JavaProcess.startWithHeap("512m", FileCheck.class.getName(), List.of());
        assertEquals("checked\n", JavaProcess.output(process));
        assertEquals(0, process.waitFor());
    }

    @Test
    void aFileOfManyGoodObstaclesIsReadInAFewSeconds() throws ScenarioException {
        byte[] bytes = ManyObstacles.text().getBytes(StandardCharsets.UTF_8);
        CpuTime time = CpuTime.start();
        Scenario content = ScenarioReader.read("file.xml", bytes);
        time.assertBelow(4);
        assertEquals(ManyObstacles.COUNT, content.setup().world().obstacles().size());
    }

    @Test
    void aRobotHasAThousandSensorsBesideTheStandardOnes() throws Exception {
        Scenario scenario = ScenarioReader.read("file.xml", sensors(1000).getBytes(StandardCharsets.UTF_8));
        assertEquals(1008, scenario.setup().robot().sensors().size());
        assertEquals(List.of(), problemsOf(new String(scenario.toBytes(), StandardCharsets.UTF_8)));
        assertEquals(
                "<robot> has too many sensors; expected at most 1008",
                problemsOf(sensors(1001)).get(0).message().toString());
    }

    @Test
    void aTinyAngleThatRoundsToZeroIsRefused() {
        String wall = "<wall id=\"w\" x=\"0\" y=\"0\" points=\"2,2 3,3\" specular=\"0." + "0".repeat(330) + "1\"/>";
        assertTrue(problemsOf(scenario(wall, ROBOT, "")).get(0).toString().contains("specular of <wall> is \"0.000"));
    }
}
