package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Random;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Comments that a person has written into a file, and what a save makes of them. */
class XmlCommentsTest {

    private static final String COMMENTED =
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <!-- Ours.
                 All of it. -->
            <scenario xmlns="urn:faultline:scenario:1" name="Room">
              <world width="6" height="4" enclosed="true">
                <!-- a --><!-- <b> & c -->
                <circle id="a/b" x="1" y="1" radius="0.1"/>
                <!-- the desk -->
                <rectangle id="a" x="4" y="3" width="1" height="0.5"/> <!-- beside it -->
              </world>
              <robot x="3" y="2"/>
              <!-- none yet -->
              <expect/>
            </scenario>
            <!-- the end -->
            """;

    @TempDir
    private Path folder;

    @Test
    void eachStaysWhereItStood() throws ScenarioException {
        assertEquals(
                """
                <?xml version="1.0" encoding="UTF-8"?>
                <!-- Ours.
                     All of it. -->
                <scenario>
                  <world>
                    <!-- a -->
                    <!-- <b> & c -->
                    <circle/>
                    <!-- the desk -->
                    <rectangle/>
                    <!-- beside it -->
                  </world>
                  <robot>
                    <motor/>
                  </robot>
                  <controller/>
                  <!-- none yet -->
                </scenario>
                <!-- the end -->
                """,
                rewritten(COMMENTED, SampleScenario.read(COMMENTED)));
    }

    @Test
    void whatStoodBeforeAnElementThatIsGoneStandsAtTheEndOfItsParent() throws ScenarioException {
        String text = rewritten(COMMENTED, without("circle"));
        assertTrue(
                text.contains(
                        """
                  <world>
                    <!-- the desk -->
                    <rectangle/>
                    <!-- a -->
                    <!-- <b> & c -->
                    <!-- beside it -->
                  </world>
                """),
                text);
        String none = rewritten(COMMENTED, without("circle|rectangle"));
        assertTrue(
                none.contains(
                        """
                  <world>
                    <!-- a -->
                    <!-- <b> & c -->
                    <!-- the desk -->
                    <!-- beside it -->
                  </world>
                """),
                none);
    }

    private static Scenario without(String element) throws ScenarioException {
        return SampleScenario.read(COMMENTED.replaceAll("<(" + element + ") [^>]*/>", ""));
    }

    /** As it is written, without the attributes. */
    private static String rewritten(String file, Scenario scenario) {
        return ScenarioWriter.toText(scenario, readComments(file)).replaceAll("(<\\w+)( [\\w]+=\"[^\"]*\")+", "$1");
    }

    private static final String EVENTS =
            """
              <timeline>
                <!-- first: away -->
                <move obstacle="p" at="1" x="4" y="3"/>
                <!-- second: back -->
                <move at="2.0" obstacle="p" x="4" y="2"/>
                <!-- third: away again -->
                <move obstacle="p" at="3" x="4" y="3"/>
              </timeline>
            """;

    /** Returns the times of the moves and the first words of the comments in the order in which they are written. */
    private static String order(String timeline) throws ScenarioException {
        return order(EVENTS, timeline);
    }

    private static String order(String before, String timeline) throws ScenarioException {
        String start =
                """
                <scenario xmlns="urn:faultline:scenario:1" name="Moves">
                  <world width="6" height="4"><circle id="p" x="4" y="2" radius="0.1"/></world>
                  <robot x="1" y="1"/>
                """;
        Scenario edited = SampleScenario.read(start + timeline + "</scenario>");
        String text = ScenarioWriter.toText(edited, readComments(start + before + "</scenario>"));
        return Pattern.compile("<move at=\"([0-9.]+)|<!-- (\\w+)")
                .matcher(text)
                .results()
                .map(found -> found.group(1) == null ? found.group(2) : found.group(1))
                .collect(Collectors.joining(" "));
    }

    @Test
    void aCommentStaysBeforeItsEventWhenAnotherEventIsRemovedOrAdded() throws ScenarioException {
        assertEquals("first 1 second 2 third 3", order(EVENTS));
        assertEquals("second 2 third 3 first", order(EVENTS.replaceAll(".*at=\"1\".*", "")));
        assertEquals("first 1 third 3 second", order(EVENTS.replaceAll(".*at=\"2.0\".*", "")));
        String added = "<move obstacle=\"p\" at=\"0.5\" x=\"3\" y=\"3\"/>";
        assertEquals("0.5 first 1 second 2 third 3", order(EVENTS.replace("<!-- first: away -->", added)));
    }

    @Test
    void aCommentStaysBeforeItsEventWhenThatIsChangedOrMovedInTime() throws ScenarioException {
        assertEquals("first 1 second 2 third 3", order(EVENTS.replace("x=\"4\"", "x=\"3\"")));
        String first = "<move obstacle=\"p\" at=\"1\" x=\"4\" y=\"3\"/>";
        assertEquals("second 2 third 3 first 5", order(move(EVENTS, first, first.replace("1", "5"))));
    }

    @Test
    void aCommentStaysBeforeAnEditedEventWhenAnotherEventIsAdded() throws ScenarioException {
        String added = "<move obstacle=\"p\" at=\"0.5\" x=\"2\" y=\"1\"/>";
        String other = EVENTS.replace("<!-- first: away -->", added);
        String first = "<move obstacle=\"p\" at=\"1\" x=\"4\" y=\"3\"/>";
        assertEquals("0.5 first 0.7 second 2 third 3", order(other.replace("at=\"1\"", "at=\"0.7\"")));
        assertEquals("0.5 second 2 third 3 first 5", order(move(other, first, first.replace("1", "5"))));
        String sameTime = EVENTS.replace("<!-- second: back -->", added.replace("0.5", "1"));
        assertEquals("first 1 1 second 2 third 3", order(sameTime.replace(first, first.replace("x=\"4\"", "x=\"3\""))));
    }

    /** Replaces a line by another at the end of a timeline. */
    private static String move(String timeline, String line, String atEnd) {
        return timeline.replace(line, "").replace("</timeline>", atEnd + "</timeline>");
    }

    @Test
    void theCommentsOfObstaclesThatArePutAtOneTimeStayWhenOneIsRemovedOrChanged() throws ScenarioException {
        String puts =
                """
                  <timeline>
                    <!-- a -->
                    <put at="3"><circle id="a" x="4" y="3" radius="0.1"/></put>
                    <!-- b -->
                    <put at="3"><circle id="b" x="4" y="2" radius="0.1"/></put>
                    <!-- c -->
                    <put at="3"><circle id="c" x="4" y="1" radius="0.1"/></put>
                  </timeline>
                """;
        assertEquals("a 3a b 3b c 3c", orderOfPuts(puts, puts));
        assertEquals("b 3b c 3c a", orderOfPuts(puts, puts.replaceAll(".*\"a\".*", "")));
        assertEquals("a 3a c 3c b", orderOfPuts(puts, puts.replaceAll(".*\"b\".*", "")));
        String added = "<put at=\"2\"><circle id=\"d\" x=\"4\" y=\"1\" radius=\"0.1\"/></put>";
        assertEquals("2d a 3a c 3c b 4b", orderOfPuts(puts, later(puts.replace("<!-- a -->", added))));
    }

    /** Puts the second obstacle a second later. */
    private static String later(String timeline) {
        String second = "<put at=\"3\"><circle id=\"b\" x=\"4\" y=\"2\" radius=\"0.1\"/></put>";
        return move(timeline, second, second.replace("at=\"3\"", "at=\"4\""));
    }

    private static String orderOfPuts(String before, String now) throws ScenarioException {
        String start =
                """
                <scenario xmlns="urn:faultline:scenario:1" name="Puts">
                  <world width="6" height="4"/>
                  <robot x="1" y="1"/>
                """;
        String text = ScenarioWriter.toText(
                SampleScenario.read(start + now + "</scenario>"), readComments(start + before + "</scenario>"));
        return Pattern.compile("<put at=\"([0-9.]+)\">\\s*<circle id=\"(\\w+)|<!-- (\\w+)")
                .matcher(text)
                .results()
                .map(found -> found.group(1) == null ? found.group(3) : found.group(1) + found.group(2))
                .collect(Collectors.joining(" "));
    }

    @Test
    void theCommentsOfManyEditedEventsAreFoundInAShortTime() throws ScenarioException {
        StringBuilder before = new StringBuilder();
        StringBuilder now = new StringBuilder();
        for (int i = 1; i <= 20_000; i++) {
            String event = "<move obstacle=\"p\" at=\"%s\" x=\"4\" y=\"%s\"/>\n";
            before.append("<!-- c").append(i).append(" -->\n").append(event.formatted(i, 1 + i % 3));
            now.append(event.formatted(i + 0.5, 2 + i % 2));
        }
        String expected = IntStream.rangeClosed(1, 20_000)
                .mapToObj(i -> "c" + i + " " + i + ".5")
                .collect(Collectors.joining(" "));
        assertTimeout(
                Duration.ofSeconds(10),
                () -> assertEquals(
                        expected, order("<timeline>" + before + "</timeline>", "<timeline>" + now + "</timeline>")));
    }

    @Test
    void aFileThatIsReadAndWrittenAgainIsTheSameWhereverTheyStand() throws ScenarioException {
        for (int seed = 0; seed < 300; seed++) {
            Random random = new Random(seed);
            String plain = ScenarioWriter.toText(new RandomScenarios(seed).next(), XmlComments.NONE);
            String commented = plain.lines()
                    .map(line -> line + "\n" + comments(random, line))
                    .collect(Collectors.joining());
            assertEquals(
                    commented,
                    ScenarioWriter.toText(SampleScenario.read(commented), readComments(commented)),
                    "seed " + seed);
        }
    }

    /** Returns no comment, or some on separate lines, indented like the elements that may follow a line. */
    private static String comments(Random random, String line) {
        boolean begins = line.startsWith("<scenario")
                || line.matches(" *<\\w.*") && !line.endsWith("/>") && !line.contains("</");
        int depth = line.length() - line.stripLeading().length() + (begins ? 2 : 0);
        return (" ".repeat(depth) + "<!--" + random.nextInt(100) + " é & <x/> ]]>-->\n")
                .repeat(Math.max(0, random.nextInt(6) - 3));
    }

    @Test
    void aFileThatNoScenarioCanBeHasNone() {
        String comment = "<!-- a -->";
        assertSame(XmlComments.NONE, readComments(comment + "<a>".repeat(100_000) + "</a>".repeat(100_000)));
        assertSame(XmlComments.NONE, readComments(comment + "<a>" + "<b/>".repeat(300_000) + "</a>"));
    }

    @Test
    void aFileThatCannotBeReadHasNone() {
        assertSame(XmlComments.NONE, XmlComments.read(folder.resolve("none.xml")));
        assertSame(XmlComments.NONE, readComments("<scenario><!-- a -->"));
        assertSame(XmlComments.NONE, readComments("<!DOCTYPE scenario><!-- a --><scenario/>"));
    }

    private static XmlComments readComments(String file) {
        return XmlComments.read(file.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void theCommentsInsideATimelineStayWhenItsOnlyEventIsRemoved() throws ScenarioException {
        String timeline =
                """
                  <timeline>
                    <!-- before -->
                    <move obstacle="p" at="1" x="4" y="3"/>
                    <!-- after -->
                  </timeline>
                """;
        assertEquals("before after", order(timeline, ""));
    }

    /** A move with two of its four attributes is the same one; with one, it is another. */
    @Test
    void anEventWithLessThanHalfOfTheAttributesIsAnotherOne() throws ScenarioException {
        String before =
                """
                  <timeline>
                    <!-- first -->
                    <move obstacle="p" at="1" x="4" y="3"/>
                    <!-- second -->
                    <move obstacle="p" at="2" x="2" y="2"/>
                  </timeline>
                """;
        String half = "<move obstacle=\"p\" at=\"5\" x=\"4\" y=\"1\"/>";
        String less = "<move obstacle=\"p\" at=\"5\" x=\"3\" y=\"1\"/>";
        assertEquals("first 5 second", order(before, "<timeline>" + half + "</timeline>"));
        assertEquals("5 first second", order(before, "<timeline>" + less + "</timeline>"));
    }

    /** The first event has half of its attributes in the new first one, and more of them in the new second one. */
    @Test
    void theMostSimilarEventIsTheSame() throws ScenarioException {
        String before = "<timeline><!-- first --><move obstacle=\"p\" at=\"1\" x=\"4\" y=\"3\"/></timeline>";
        String now = "<timeline><move obstacle=\"p\" at=\"2\" x=\"4\" y=\"1\"/>"
                + "<move obstacle=\"p\" at=\"3\" x=\"4\" y=\"3\"/></timeline>";
        assertEquals("2 first 3", order(before, now));
    }

    /** Two of the five attributes of the first event stay, and the second event is removed. */
    @Test
    void anEventThatIsSimilarToNoneIsTheOneOfItsTime() throws ScenarioException {
        String event = "<move obstacle=\"p\" at=\"%s\" x=\"%s\" y=\"%s\" heading=\"%s\"/>";
        String before = "<timeline><!-- first -->" + event.formatted(1, 4, 3, 10) + "<!-- second -->"
                + event.formatted(2, 4, 2, 20) + "</timeline>";
        assertEquals("first 1 second", order(before, "<timeline>" + event.formatted(1, 3, 1, 30) + "</timeline>"));
    }

    @Test
    void aNumberIsTheSameHoweverItIsWritten() throws ScenarioException {
        String before =
                """
                  <timeline>
                    <!-- first -->
                    <move obstacle="p" at="5.0" x="4.00" y="1e0"/>
                    <!-- second -->
                    <move obstacle="p" at="5" x="3" y="2"/>
                  </timeline>
                """;
        String now = before.replace("<!-- first -->", "<move obstacle=\"p\" at=\"5\" x=\"4\" y=\"2\"/>");
        assertEquals("5 first 5 second 5", order(before, now));
    }
}
