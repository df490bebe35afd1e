package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.text.Translations;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files that are not scenarios, or are hostile; each gives one line. */
class HostileFilesTest {

    private static final String OPEN = "<scenario xmlns=\"urn:faultline:scenario:1\">";

    @TempDir
    private Path folder;

    private String problemIn(byte[] bytes) throws IOException {
        Path file = Files.write(folder.resolve("file.xml"), bytes);
        return problemIn(file);
    }

    private String problemIn(String text) throws IOException {
        return problemIn(text.getBytes(StandardCharsets.UTF_8));
    }

    private String problemIn(Path file) {
        ScenarioException exception = assertThrows(ScenarioException.class, () -> Scenario.load(file));
        exception.problems().forEach(problem -> Translations.assertTranslated(problem.message()));
        return exception.getMessage().replace(folder + "/", "");
    }

    @Test
    void anUnreadableFileIsReportedWithoutALocation() throws IOException {
        assertEquals("none.xml: there is no such file", problemIn(folder.resolve("none.xml")));
        assertEquals(folder + ": this is a folder; expected a scenario file", problemIn(folder));
        assertEquals("file.xml:1:1: the file is empty; expected a scenario", problemIn(""));
    }

    @Test
    void aFileBeyondTheLimitIsRefusedUnread() throws IOException {
        assertEquals("file.xml: the file has 16.1 MiB; expected at most 16 MiB", problemIn(new byte[(16 << 20) + 1]));
    }

    @Test
    void malformedXmlIsReportedWhereItBreaks() throws IOException {
        String problem = "file.xml:1:1: this is not XML; expected a document that begins with <scenario>";
        assertEquals(problem, problemIn(new byte[] {0, 1, 2, 3}));
        assertEquals(problem, problemIn("hello"));
        assertEquals(
                "file.xml:1:53: this is not well-formed XML, after "
                        + "\"...lns=\"urn:faultline:scenario:1\"><world></\", inside <world> of line 1",
                problemIn(OPEN + "<world></robot></scenario>"));
        assertEquals(
                "file.xml:1:30: this is not well-formed XML, after \"<scenario name=\"a\" name=\"b\"/>\"",
                problemIn("<scenario name=\"a\" name=\"b\"/>"));
        assertEquals(
                "file.xml:1:20: this is not well-formed XML, after \"<a:scenario name=\"a\"",
                problemIn("<a:scenario name=\"a<b\"/>"));
        assertEquals(
                "file.xml:1:1: the file names the encoding \"klingon\", which is not supported; expected UTF-8",
                problemIn("<?xml version=\"1.0\" encoding=\"klingon\"?><scenario/>"));
        assertEquals(
                "file.xml:1:17: the bytes are not text in UTF-8, and the file names no other encoding",
                problemIn("<scenario name=\"\u00ff\"/>".getBytes(StandardCharsets.ISO_8859_1)));
    }

    @Test
    void anEncodingThatDoesNotFitTheBytesIsReported() throws IOException {
        String declaration = "<?xml version='1.0' encoding='%s'?><scenario/>";
        String other = "the bytes are not text in the encoding that the file names; expected UTF-8";
        for (String name : List.of("IBM037", "UTF-16")) {
            assertEquals(other, problemIn(declaration.formatted(name)).split(": ", 2)[1]);
        }
    }

    /** A file that was written twice or padded by a crash. */
    @ParameterizedTest
    @ValueSource(strings = {"<scenario/>", "x", "\0\0"})
    void whatFollowsTheRootElementIsReported(String rest) throws IOException {
        String problem = problemIn(OPEN + "</scenario>\n" + rest);
        assertEquals(
                "there is text after the end of <scenario>; expected the end of the file", problem.split(": ", 2)[1]);
    }

    @Test
    void aWrongCommentAfterTheRootElementIsReportedWhereItBreaks() throws IOException {
        String problem = problemIn(OPEN + "</scenario>\n<!-- a -- b -->");
        assertEquals("this is not well-formed XML, after \"<!-- a --\"", problem.split(": ", 2)[1]);
    }

    @Test
    void aFileInUtf16ThatSaysUtf8IsReportedAsSuch() throws IOException {
        for (Charset charset : List.of(StandardCharsets.UTF_16BE, StandardCharsets.UTF_16LE, StandardCharsets.UTF_16)) {
            assertEquals(
                    "the bytes are not text in the encoding that the file names; expected UTF-8",
                    problemIn("<?xml version=\"1.0\" encoding=\"UTF-8\"?><scenario/>".getBytes(charset))
                            .split(": ", 2)[1]);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"seed=\"\u0661\"", "duration=\"\u20035\"", "recorded=\"\u2003true\"", "seed=\"\u20031\""})
    void oddDigitsAndBlanksAreReportedByTheirValue(String attribute) throws IOException {
        String text = OPEN.replace(">", " " + attribute + "><world width=\"6\" height=\"4\"/><robot x=\"1\" y=\"1\"/>")
                + "</scenario>";
        String problem = problemIn(text);
        assertTrue(problem.contains(attribute.split("=")[0] + " of <scenario> is \""), problem);
    }

    @Test
    void anObstacleMayHaveAQuestionMarkForItsId() throws Exception {
        String text = OPEN + "<world width=\"6\" height=\"4\"><circle id=\"?\" x=\"3\" y=\"3\" radius=\"0.1\"/></world>"
                + "<robot x=\"1\" y=\"1\"/><timeline><remove at=\"1\" obstacle=\"?\"/></timeline></scenario>";
        Scenario.load(Files.writeString(folder.resolve("good.xml"), text));
        String wrong = text.replace("id=\"?\"", "id=\"x\"");
        assertTrue(problemIn(wrong).contains("obstacle of <remove> is \"?\"; expected one of the obstacles: x"));
    }

    @Test
    void aWrongRootOrNamespaceIsReportedWithTheRightOne() throws IOException {
        String allowed = "; expected <scenario xmlns=\"urn:faultline:scenario:1\">";
        assertEquals("file.xml:1:12: the root element is <scenario xmlns=\"\">" + allowed, problemIn("<scenario/>"));
        assertEquals(
                "file.xml:1:42: the root element is <scene>" + allowed,
                problemIn("<scene xmlns=\"urn:faultline:scenario:1\"/>"));
        assertEquals(
                "file.xml:1:31: the root element is <svg xmlns=\"urn:x\">" + allowed,
                problemIn("<svg xmlns=\"urn:x\" width=\"1\"/>"));
    }

    @Test
    void noEntityIsReadOrExpanded() throws IOException {
        assertEquals(
                "file.xml:2:10: this has a DOCTYPE; expected none",
                problemIn(
                        """
                <?xml version="1.0"?>
                <!DOCTYPE scenario [<!ENTITY secret SYSTEM "file:///etc/passwd">]>
                <scenario>&secret;</scenario>
                """));
        assertEquals(
                "file.xml:1:10: this has a DOCTYPE; expected none",
                problemIn(
                        """
                <!DOCTYPE a [<!ENTITY a "aaaaaaaa"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;">]><a>&c;</a>
                """));
        assertEquals(
                "file.xml:1:10: this has a DOCTYPE; expected none",
                problemIn("<!DOCTYPE scenario SYSTEM \"http://localhost:1/scenario.dtd\"><scenario/>"));
    }

    @Test
    void deepNestingEndsAtOnce() throws IOException {
        assertEquals(
                "file.xml:1:101: the elements are nested too deep; expected at most 20",
                problemIn(OPEN + "<a>".repeat(1_000_000)));
    }

    @Test
    void megabytesOfAttributesAreReportedInOneLine() throws IOException {
        String points = OPEN + "<world width=\"6\" height=\"4\"><wall id=\"w\" x=\"0\" y=\"0\" points=\""
                + "1,1 ".repeat(3_000_000) + "\"/></world><robot x=\"1\" y=\"1\"/></scenario>";
        assertEquals(
                "points of <wall> has too many points; expected at most 100000 " + "obstacles and points in the file",
                problemIn(points).split(": ", 2)[1]);
        String id = OPEN + "<world width=\"6\" height=\"4\"><circle radius=\"1\" x=\"3\" y=\"3\" id=\""
                + "i".repeat(12_000_000) + "\"/></world><robot x=\"1\" y=\"1\"/></scenario>";
        assertEquals(
                "id of <circle> is \"" + "i".repeat(60)
                        + "...\"; expected 1 to 100 characters, none of them a comma, a double quote or a "
                        + "control character",
                problemIn(id).split(": ", 2)[1]);
        String number = OPEN + "<world width=\"6\" height=\"" + "4".repeat(12_000_000)
                + "\"/><robot x=\"1\" y=\"1\"/></scenario>";
        assertEquals(
                "height of <world> is \"" + "4".repeat(60) + "...\"; expected a number from 0.000001 to 100000 metres",
                problemIn(number).split(": ", 2)[1]);
    }

    @Test
    void hundredsOfThousandsOfElementsAreReportedInOneLine() throws IOException {
        assertEquals(
                "the file has too many elements; expected at most 300000",
                problemIn(OPEN + "<world width=\"6\" height=\"4\">" + "<b/>".repeat(400_000))
                        .split(": ", 2)[1]);
        StringBuilder circles = new StringBuilder(OPEN + "<world width=\"6\" height=\"4\">");
        for (int i = 0; i <= ScenarioLimits.MAX_PARTS; i++) {
            circles.append("<circle id=\"c").append(i).append("\" x=\"3\" y=\"3\" radius=\"0.1\"/>");
        }
        assertEquals(
                "<world> has too many obstacles and points; expected at most 100000 in total",
                problemIn(circles + "</world><robot x=\"1\" y=\"1\"/></scenario>")
                        .split(": ", 2)[1]);
    }

    @Test
    void nothingOfAnotherNamespaceHasAnyEffect() throws IOException {
        assertEquals(
                "file.xml:1:154: <world> must not contain <xi:include "
                        + "xmlns=\"http://www.w3.org/2001/XInclude\">; expected rectangle, circle, "
                        + "ellipse, polygon, wall, plan",
                problemIn(OPEN
                        + "<world width=\"6\" height=\"4\"><xi:include xmlns:xi=\"http://www.w3.org/2001/XInclude\""
                        + " href=\"file:///etc/passwd\"/></world><robot x=\"1\" y=\"1\"/></scenario>"));
        assertEquals(
                "file.xml:1:164: <robot> has no attribute \"xsi:type\"; expected x, y, "
                        + "heading, length, width, track, trackScale, speed, turnRate, "
                        + "defaultSensors",
                problemIn(OPEN + "<world width=\"6\" height=\"4\"/><robot x=\"1\" y=\"1\" xsi:type=\"motor\" "
                        + "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"/></scenario>"));
    }

    @Test
    void textsAreOfLimitedLength() throws IOException {
        String rest = "<world width=\"6\" height=\"4\"/><robot x=\"1\" y=\"1\"/></scenario>";
        String named = OPEN.replace(">", " name=\"%s\">") + rest;
        String described = OPEN + "<description>%s</description>" + rest;
        assertEquals(
                "name of <scenario> is \"" + "n".repeat(60) + "...\"; expected at most 10000 characters",
                problemIn(named.formatted("n".repeat(16_000_000))).split(": ", 2)[1]);
        assertEquals(
                "<description> contains 16000000 characters; expected at most 100000",
                problemIn(described.formatted("d".repeat(16_000_000))).split(": ", 2)[1]);
        assertEquals(List.of(), SampleScenario.problems(named.formatted("n".repeat(10_000))));
        assertEquals(
                1, SampleScenario.problems(named.formatted("n".repeat(10_001))).size());
        assertEquals(List.of(), SampleScenario.problems(described.formatted("d".repeat(100_000))));
        assertEquals(
                1,
                SampleScenario.problems(described.formatted("d".repeat(100_001)))
                        .size());
        String states = "<expect states=\"" + "SEARCH ".repeat(150) + "\"/></scenario>";
        assertEquals(
                "states of <expect> is \"" + "SEARCH ".repeat(9).substring(0, 60)
                        + "...\"; expected at most 1000 characters",
                problemIn(OPEN + rest.replace("</scenario>", states)).split(": ", 2)[1]);
    }

    @Test
    void anElementThatMustBeEmptyHoldsNoWhiteSpace() throws IOException {
        assertEquals(
                "file.xml:1:99: <motor> contains the text \" \"; expected nothing",
                problemIn(OPEN
                        + "<world width=\"6\" height=\"4\"/><robot x=\"1\" y=\"1\">"
                        + "<motor>\n</motor></robot></scenario>"));
    }

    @Test
    void theLocationOfASchemaIsIgnoredInItsOwnNamespaceOnly() throws IOException {
        String text = OPEN.replace(">", " xmlns:xsi=\"%s\" xsi:schemaLocation=\"a b\">")
                + "<world width=\"6\" height=\"4\"/><robot x=\"1\" y=\"1\"/></scenario>";
        assertEquals(List.of(), SampleScenario.problems(text.formatted("http://www.w3.org/2001/XMLSchema-instance")));
        assertTrue(problemIn(text.formatted("urn:x"))
                .contains("<scenario> has no attribute \"xsi:schemaLocation xmlns=\"urn:x\"\"; expected name, "));
    }
}
