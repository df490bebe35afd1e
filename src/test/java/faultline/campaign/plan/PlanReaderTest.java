package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.campaign.RoomRules;
import faultline.scenario.xml.ScenarioException;
import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class PlanReaderTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            <set attribute="robot/sensor[front]/@cone" value="5 200"/> | plan.xml:3:59: cone of <sensor> is "200"; expected a number without exponent, more than 0 and less than 180 degrees (in room)
            <set attribute="robot/sensor[frnt]/@cone" value="5"/> | plan.xml:3:54: <sensor> "frnt" lacks x, y and bearing; expected these attributes for a new sensor, or one of front, front-left, left, rear-left, rear, rear-right, right, front-right; did you mean "front"? (in room)
            <set attribute="robot/sensor[front]/@cone" value="20, 10, 5"/> | plan.xml:3:63: value of <set> is "20, 10, 5"; expected one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C; at most 100000 values
            <faults><fault sensor="front" kind="stuck" value="0-0.8" at="1"/></faults> | plan.xml:3:66: value of <fault> is "0-0.8"; expected one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C; at most 100000 values
            <set attribute="robot/@sped" value="5"/> | plan.xml:3:41: <robot> has no attribute "sped"; expected x, y, heading, length, width, track, trackScale, speed, turnRate, defaultSensors; did you mean "speed"? (in room)
            <set attribute="robot/speed" value="5"/> | plan.xml:3:41: attribute of <set> is "robot/speed"; expected a path in a scenario file, such as robot/sensor[front]/@cone, controller/@distance or @duration
            <set attribute="@seed" value="5 6" name="s"/> | plan.xml:3:46: attribute of <set> is "@seed"; expected another attribute; <seeds> gives the runs their seeds
            <variants><variant name="a"><set attribute="@seed" value="7"/></variant></variants> | plan.xml:3:63: attribute of <set> is "@seed"; expected another attribute; <seeds> gives the runs their seeds
            <set attribute="world/circle[pale]/@x" value="1"/> | plan.xml:3:51: attribute of <set> is "world/circle[pale]/@x", but <world> has no circle[pale]; did you mean "pole"? (in room)
            <set attribute="robot/@speed" value="3..2"/> | plan.xml:3:45: value of <set> is "3..2"; expected one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C; at most 100000 values
            <set attribute="robot/@speed" value="0.1..1e999/3"/> | plan.xml:3:53: speed of <robot> is "1e999"; expected a number more than 0 and at most 1000 metres per second (in room)
            <faults><fault sensor="front" kind="stuck" value="0.1" at="1..1e999"/></faults> | plan.xml:3:71: at of <fault> is "1e999"; expected a number from 0 to 10000000 seconds (in room)
            <set attribute="robot/@speed" value="0..1"/> | plan.xml:3:45: speed of <robot> is "0"; expected a number more than 0 and at most 1000 metres per second (in room)
            <faults><fault sensor="frnt" kind="off" at="1"/></faults> | plan.xml:3:49: sensor of <fault> is "frnt"; expected one of the robot's sensors: front, front-left, left, rear-left, rear, rear-right, right, front-right; did you mean "front"? (in room)
            <faults><fault sensor="front" kind="any of off stick" at="1"/></faults> | plan.xml:3:63: kind of <fault> is "stick"; expected off, stuck, bias, dropout, stuck-at-last, scale, drift, noise, quantised, bursts, delayed, short-range and 5 more; did you mean "stuck"? (in room)
            <set attribute="robot/@x" value="4"/> | plan.xml:3:38: <robot> starts at 4,1.2 outside of the enclosed world; expected x from 0 to 3 and y from 0 to 2 (in room)
            <faults><fault sensor="front" kind="off" att="1"/></faults> | plan.xml:3:51: <fault> has no attribute "att"; expected kind, sensor, motor, value, length, at, until, lasts, label; did you mean "at"?
            <faults/> | plan.xml:3:10: <faults> contains no fault; expected one or more <fault> or <healthy>
            <fault sensor="front"/> | plan.xml:3:24: <campaign> must not contain <fault>; expected description, worlds, seeds, set, variants, faults, masks; did you mean "faults"?
            <seeds count="1"/><seeds count="2"/> | plan.xml:3:37: <campaign> contains a second <seeds>; expected one
            <seeds count="10000000"/><set attribute="robot/@speed" value="0.1 0.2"/> | plan.xml:1:57: the plan has 20000000 runs; expected 10000000 or fewer
            <seeds count="0"/> | plan.xml:3:19: count of <seeds> is "0"; expected a whole number from 1 to 10000000
            <set attribute="robot/@speed" value="0.1 0.2" name="run"/> | plan.xml:1:57: two columns of runs.csv would have the name "run"; expected unique names (set another with the attribute name)
            <set attribute="@tick" value="0.1"/><set attribute="scenario/@tick" value="0.2"/> | plan.xml:3:82: the attribute "@tick" is set twice; expected one element that sets it
            <set attribute="robot/@speed" value="0.1 0.2"/><set attribute="robot/@speed" value="0.3..0.4" name="drawn"/> | plan.xml:3:109: the attribute "robot/@speed" is set twice; expected one element that sets it
            <set attribute="robot/@speed" value="0.1 0.2"/><set attribute="robot/@speed" value="0.3" name="one"/> | plan.xml:3:48: the attribute "robot/@speed" is set twice; expected one element that sets it
            <set attribute="robot/@speed" value="0.1 0.2"/><variants><variant name="a"><set attribute="robot/@speed" value="0.3"/></variant></variants> | plan.xml:3:119: the attribute "robot/@speed" is set twice; expected one element that sets it
            <variants><variant name="a"><set attribute="@tick" value="0.1"/><set attribute="@tick" value="0.1"/></variant></variants> | plan.xml:3:101: the attribute "@tick" is set twice; expected one element that sets it
            <masks sensors="front"/><set attribute="robot/sensor[front]/@on" value="any of true false"/> | plan.xml:3:93: the attribute "robot/sensor[front]/@on" is set twice; expected one element that sets it
            <masks><mask on="front left"/><mask on="left front"/></masks> | plan.xml:3:54: on of <mask> is "left front"; expected a set of sensors that no other <mask> has
            <faults><healthy/><healthy/></faults> | plan.xml:3:29: <healthy> is the same as an earlier one; expected each fault once
            <faults><fault kind="off stuck" sensor="front" at="1..2"/><fault sensor="front" at="1..2" kind="stuck"/></faults> | plan.xml:3:105: <fault> is the same as an earlier one; expected each fault once
            <faults><fault kind="off" sensor="front" at="1" until="2" lasts="3"/></faults> | plan.xml:3:70: <fault> has both lasts and until; expected one of them
            <faults><fault kind="off" sensor="front" at="1" lasts="0"/></faults> | plan.xml:3:60: lasts of <fault> gives its end: until of <fault> is 1; expected a time after at, which is 1 (in room)
            <faults><fault kind="off" sensor="front" at="9999999" lasts="5"/></faults> | plan.xml:3:66: lasts of <fault> gives its end: until of <fault> is "10000004"; expected a number from 0 to 10000000 seconds (in room)
            <set attribute="controller/@type" value="none extern"/> | plan.xml:3:56: the controller is from outside, which no plan can name; expected one of the program or of --jar (in room)
            <set attribute="controller/@type" value="extern"/><variants><variant name="a"/></variants> | plan.xml:3:51: the controller is from outside, which no plan can name; expected one of the program or of --jar (in room)
            <set attribute="controller/setting[1]/@value" value="1"/> | plan.xml:3:58: attribute of <set> is "controller/setting[1]/@value", but <controller> has no setting[1] (in room)
            <set attribute="controller/setting[a]/@value" value="1"/> | plan.xml:3:58: <controller> must not contain <setting>; expected nothing (in room)
            <masks sensors='front "left'/> | plan.xml:3:31: sensors of <masks> is "front "left"; expected ids with blanks between them, with whole ids in double quotes; at most 100000 of them
            <faults><fault sensor='"left' kind="off" at="1"/></faults> | plan.xml:3:50: sensor of <fault> is ""left"; expected ids with blanks between them, or any of A B C, with whole ids in double quotes; at most 100000 ids
            <faults><fault sensor="2..1" kind="off" at="1"/></faults> | plan.xml:3:49: sensor of <fault> is "2..1"; expected one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C; at most 100000 values
            <faults><fault sensor="left" kind="stuck" value='2..1 "' at="1"/></faults> | plan.xml:3:66: value of <fault> is "2..1 ""; expected one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C; at most 100000 values
            <set attribute="robot/@speed" value="0.1..2000"/> | plan.xml:3:50: speed of <robot> is "2000"; expected a number more than 0 and at most 1000 metres per second (in room)
            <variants><variant name="a"><set attribute="robot/@speed" value="-1"/><set attribute="@duration" value="5"/></variant></variants> | plan.xml:3:71: speed of <robot> is "-1"; expected a number more than 0 and at most 1000 metres per second (in room)
            <faults><fault kind="off" sensor="frnt" at="1" lasts="2"/></faults> | plan.xml:3:59: sensor of <fault> is "frnt"; expected one of the robot's sensors: front, front-left, left, rear-left, rear, rear-right, right, front-right; did you mean "front"? (in room)
            <faults><fault kind="off" sensor="front" at="1" until="0.5"/></faults> | plan.xml:3:62: until of <fault> is 0.5; expected a time after at, which is 1 (in room)
            <variants/> | plan.xml:3:12: <variants> contains no variant; expected one or more
            <variants><variant name="a"/><variant name="b"/><variant name="a"/></variants> | plan.xml:3:68: name of <variant> is "a"; expected a unique name
            <masks sensors="front left"><mask on="rear"/></masks> | plan.xml:3:46: on of <mask> is "rear"; expected some of front, left
            """)
    void everyMistakeIsReportedAtItsPlace(String element, String problem) {
        assertEquals(List.of(problem), SamplePlan.problems(element));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            <rooms first="3" count="4"/><rooms first="6" count="2"/> | <rooms> contains the world "room-6", which is there already; expected each world once
            <rooms first="6" count="2"/><rooms first="3" count="4"/> | <rooms> contains the world "room-6", which is there already; expected each world once
            <rooms first="6"/><scenario file="a.xml" name="room-6"/> | name of <scenario> is "room-6", which another scenario already has; expected unique names
            <scenario file="a.xml" name="A"/><scenario file="b.xml" name="A"/> | name of <scenario> is "A", which another scenario already has; expected unique names
            <scenario file="a.xml" name="A"/><scenario file="a.xml" name="B"/> | file of <scenario> is "a.xml", which another scenario already has; expected each file once
            <scenario file="room-7.xml"/><rooms first="6" count="2"/> | <rooms> contains the world "room-7", which is there already; expected each world once
            """)
    void aWorldIsThereOnce(String worlds, String problem) {
        ScenarioException refusal = assertThrows(
                ScenarioException.class, () -> SamplePlan.read(SamplePlan.text("", "<worlds>" + worlds + "</worlds>")));
        assertEquals(1, refusal.problems().size());
        assertEquals(problem, refusal.problems().get(0).toString().replaceFirst("^plan.xml:2:\\d+: ", ""));
    }

    @Test
    void theRootElementIsACampaign() {
        String plan =
                SamplePlan.text("", "").replace("campaign xmlns", "plan xmlns").replace("/campaign", "/plan");
        ScenarioException refusal = assertThrows(ScenarioException.class, () -> SamplePlan.read(plan));
        assertEquals(
                List.of("plan.xml:1:53: the root element is <plan>;"
                        + " expected <campaign xmlns=\"urn:faultline:campaign:1\">"),
                refusal.problems().stream().map(Object::toString).toList());
    }

    private static final String EVERY_ELEMENT = SamplePlan.text(
            "",
            """
            <description>Words</description>
            <worlds><scenario file="room.xml"/><rooms first="3"/></worlds>
            <seeds count="2"/>
            <set attribute="@duration" value="1 2"/>
            <variants><variant name="a"><set attribute="robot/@speed" value="0.1"/></variant></variants>
            <faults><healthy/><fault sensor="front" kind="off" at="1"/></faults>
            <masks sensors="front left"><mask on="front"/></masks>
            """);

    /** A misspelt attribute or element would otherwise be ignored, and the campaign would be another one. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "campaign xmlns",
                "description",
                "worlds",
                "scenario file",
                "rooms first",
                "seeds count",
                "set attribute=\"@duration",
                "variants",
                "variant name",
                "set attribute=\"robot",
                "faults",
                "healthy",
                "fault sensor",
                "masks sensors",
                "mask on"
            })
    void anUnknownAttributeOrElementIsReportedInEveryElement(String begin) throws Exception {
        SamplePlan.read(EVERY_ELEMENT);
        String name = begin.split(" ")[0];
        int tag = EVERY_ELEMENT.indexOf("<" + begin);
        int afterName = tag + 1 + name.length();
        String attribute = EVERY_ELEMENT.substring(0, afterName) + " odd=\"1\"" + EVERY_ELEMENT.substring(afterName);
        assertReported(attribute, "<" + name + "> has no attribute \"odd\"");

        int end = EVERY_ELEMENT.indexOf('>', tag);
        boolean isEmpty = EVERY_ELEMENT.charAt(end - 1) == '/';
        String element = EVERY_ELEMENT.substring(0, isEmpty ? end - 1 : end) + "><odd/>"
                + (isEmpty ? "</" + name + ">" : "") + EVERY_ELEMENT.substring(end + 1);
        assertReported(element, "<" + name + "> must not contain <odd>");
    }

    private static void assertReported(String plan, String problem) {
        ScenarioException refusal = assertThrows(ScenarioException.class, () -> SamplePlan.read(plan));
        assertTrue(
                refusal.problems().stream().anyMatch(each -> each.toString().contains(": " + problem)),
                refusal::getMessage);
    }

    /** A comparison of all pairs takes several times as long, as does a room for each element. */
    @Test
    void manyRoomsAreReadInAlmostLinearTime() throws ScenarioException {
        String rooms = IntStream.range(0, 50_000)
                .mapToObj(i -> "<rooms first=\"" + i + "\" visitors=\"" + i % 4 + "\"/>")
                .collect(Collectors.joining());
        CpuTime time = CpuTime.start();
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds>" + rooms + "</worlds>"));
        time.assertBelow(10);
        assertEquals(50_000, plan.worldCount());
        assertEquals("room-49999-visitors-3", plan.run(49_999).world());
    }

    @Test
    void masksOfMoreSensorsThanARobotHasAreRefused() {
        String sensors = IntStream.range(0, 1009).mapToObj(i -> "s" + i).collect(Collectors.joining(" "));
        List<String> problems =
                SamplePlan.problems("<masks sensors=\"" + sensors + "\"><mask on=\"s0\"/><mask on=\"s1\"/></masks>");
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains(": sensors of <masks> is \"s0 s1"), problems.get(0));
        assertTrue(problems.get(0).endsWith("; expected at most 1008 of them"), problems.get(0));
    }

    /** The first hundred are listed. */
    @Test
    void levelsAreTriedUntilThereAreAThousandProblems() {
        String values = IntStream.range(1, 3000).mapToObj(i -> "-" + i).collect(Collectors.joining(" "));
        List<String> problems = SamplePlan.problems("<set attribute=\"robot/@speed\" value=\"" + values + "\"/>");
        assertEquals(101, problems.size());
        assertTrue(problems.get(0).contains("speed of <robot> is \"-1\""), problems.get(0));
        assertTrue(problems.get(100).endsWith("more problems: 900"), problems.get(100));
    }

    @Test
    void anAttributeIsFoundTwiceByTheIdAndTheNumberOfItsElement() {
        String twice = "; expected one element that sets it";
        assertEquals(
                List.of("plan.xml:4:64: the attribute \"world/circle/@x\" is set twice" + twice),
                SamplePlan.problems(
                        """
                        <set attribute="world/circle[pole]/@x" value="2 2.2"/>
                        <set attribute="world/circle/@x" value="2.1 2.3" name="other"/>
                        """));
        assertEquals(
                List.of(),
                SamplePlan.problems(
                        """
                        <set attribute="world/circle[pole]/@x" value="2 2.2"/>
                        <set attribute="world/circle[1]/@y" value="0.5 0.6" name="other"/>
                        """));
    }

    @Test
    void everyWordOfAChoiceIsChecked() {
        List<String> problems =
                SamplePlan.problems("<set attribute=\"controller/@timing\" value=\"any of range nonsense range\"/>");
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("timing of <controller> is \"nonsense\""), problems::toString);
        problems = SamplePlan.problems(
                "<set attribute=\"controller/@timing\" value=\"any of range nonsense equal-readings\"/>");
        assertEquals(1, problems.size(), problems::toString);
    }

    @Test
    void otherRoomsAndVariantsThatReplaceAValueAreGood() throws Exception {
        SamplePlan.read(
                SamplePlan.text(
                        "",
                        """
                <worlds><rooms first="3" count="3"/><rooms first="6"/><rooms first="3" visitors="1"/></worlds>
                <set attribute="robot/@speed" value="0.3"/>
                <variants><variant name="usual"/>
                  <variant name="slow"><set attribute="robot/@speed" value="0.2"/></variant></variants>
                """));
    }

    @Test
    void moreCombinationsOfAFaultThanAPlanMayHaveAreCountedAndNotMade() {
        assertEquals(
                List.of("plan.xml:4:74: the plan has 10000000000 runs; expected 10000000 or fewer"),
                SamplePlan.problems(
                        """
                        <faults>
                        <fault sensor="left" kind="stuck" value="0..1/100000" at="0..10/100000"/>
                        </faults>
                        """));
    }

    @Test
    void aPlanMayHaveTheMaximumNumberOfRuns() {
        assertEquals(List.of(), SamplePlan.problems("<seeds count=\"" + CampaignPlan.MAX_RUNS + "\"/>"));
    }

    @Test
    void aProblemOfAllRoomsNamesTheFirst() {
        for (String speeds : List.of("-1", "0.1 -1")) {
            String plan = SamplePlan.text(
                    "",
                    "<worlds><rooms first=\"3\" count=\"2\"/></worlds><set attribute=\"robot/@speed\" value=\"" + speeds
                            + "\"/>");
            ScenarioException refusal = assertThrows(ScenarioException.class, () -> SamplePlan.read(plan));
            assertEquals(1, refusal.problems().size(), refusal::getMessage);
            assertTrue(refusal.getMessage().endsWith(" metres per second (in room-3)"), refusal::getMessage);
        }
    }

    /** The name of each replay and a cell of each row has them. */
    @Test
    void namesThatAreTooLongAreRefused() throws ScenarioException {
        String longest = "n".repeat(10_000);
        String elements = "<worlds><scenario file=\"room.xml\" name=\"%1$s\"/></worlds>"
                + "<faults><fault kind=\"off\" sensor=\"front\" at=\"1\" label=\"%1$s\"/></faults>";
        String plan = SamplePlan.text("", String.format(elements, longest)).replace("Test", longest);
        SamplePlan.read(plan);
        ScenarioException refusal =
                assertThrows(ScenarioException.class, () -> SamplePlan.read(plan.replace(longest, longest + "n")));
        assertEquals(
                List.of("name of <campaign>", "name of <scenario>", "label of <fault>"),
                refusal.problems().stream()
                        .map(problem -> problem.message().toString())
                        .peek(text -> assertTrue(text.endsWith("..\"; expected at most 10000 characters"), text))
                        .map(text -> text.substring(0, text.indexOf(" is ")))
                        .toList());
    }

    @Test
    void anEmptyFileIsReportedAsOne() {
        ScenarioException refusal = assertThrows(ScenarioException.class, () -> SamplePlan.read(""));
        assertEquals("plan.xml:1:1: the file is empty; expected a campaign plan", refusal.getMessage());
    }

    @Test
    void aWorldWithoutAValidFileIsReportedOnce() {
        String plan = SamplePlan.text("", "<worlds><scenario file=\"a,b.xml\"/></worlds>");
        PlanFiles.Resolver none = (number, name) -> {
            throw new AssertionError("nothing is to be read");
        };
        ScenarioException refusal = assertThrows(
                ScenarioException.class,
                () -> PlanReader.read("plan.xml", plan.getBytes(StandardCharsets.UTF_8), none));
        assertEquals(
                List.of("plan.xml:2:35: file of <scenario> is \"a,b.xml\"; expected 1 to 100 characters, none of them a"
                        + " comma, a double quote or a control character"),
                refusal.problems().stream().map(Object::toString).toList());
    }

    @Test
    void theCopyInTheDocumentsIsTheSchemaOfTheProgram() throws Exception {
        assertEquals(
                Files.readString(Path.of("src/main/resources/faultline/campaign/plan/campaign-1.xsd")),
                Files.readString(Path.of("docs/campaign-1.xsd")));
    }

    @Test
    void theSchemaHasTheBoundsOfTheProgram() throws Exception {
        Document schema =
                DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(new File("docs/campaign-1.xsd"));
        assertEquals(bounds(RoomRules.MIN_CORNER, RoomRules.MAX_CORNER), bounds(schema, "xs:attribute", "minCorner"));
        assertEquals(bounds(0, RoomRules.MAX_VISITORS), bounds(schema, "xs:attribute", "visitors"));
        assertEquals(bounds(0, CampaignPlan.MAX_SEED), bounds(schema, "xs:simpleType", "room"));
        assertEquals(bounds(-CampaignPlan.MAX_SEED, CampaignPlan.MAX_SEED), bounds(schema, "xs:simpleType", "seed"));
        assertEquals(bounds(1, CampaignPlan.MAX_RUNS), bounds(schema, "xs:simpleType", "count"));
        assertEquals(5, schema.getElementsByTagName("xs:minInclusive").getLength(), "every bound is checked here");
    }

    private static List<Long> bounds(long min, long max) {
        return List.of(min, max);
    }

    private static List<Long> bounds(Document schema, String kind, String name) {
        NodeList elements = schema.getElementsByTagName(kind);
        Element owner = IntStream.range(0, elements.getLength())
                .mapToObj(i -> (Element) elements.item(i))
                .filter(element -> element.getAttribute("name").equals(name))
                .findFirst()
                .orElseThrow();
        return Stream.of("xs:minInclusive", "xs:maxInclusive")
                .map(facet -> (Element) owner.getElementsByTagName(facet).item(0))
                .map(facet -> Long.valueOf(facet.getAttribute("value")))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"Speed", "2fast", "_speed", "top-speed", "speed ", "top speed", "LONG"})
    void aColumnHasAShortNameInLowerSnakeCase(String name) {
        String longest = "s".repeat(61);
        assertEquals(List.of(), SamplePlan.problems(speedsNamed(longest)));
        assertEquals(List.of(), SamplePlan.problems(speedsNamed("top_speed_2")));
        String wrong = name.replace("LONG", longest + "s");
        List<String> problems = SamplePlan.problems(speedsNamed(wrong));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("name of <set> is \"" + name.replace("LONG", "sss")), problems::toString);
        assertTrue(
                problems.get(0)
                        .endsWith("; expected lower-case letters, digits and underscores, beginning with a letter"),
                problems::toString);
    }

    private static String speedsNamed(String name) {
        return "<set attribute=\"robot/@speed\" value=\"0.1 0.2\" name=\"" + name + "\"/>";
    }

    @Test
    void allCombinationsOfUpToSixteenSensorsAreTried() throws ScenarioException {
        List<String> ids = IntStream.range(0, 17).mapToObj(i -> "s" + i).toList();
        String sensors = ids.stream()
                .map(id -> "<sensor id=\"" + id + "\" x=\"0.1\" y=\"0\" bearing=\"0\"/>")
                .collect(Collectors.joining());
        String room = SamplePlan.ROOM.replace("y=\"1.2\"/>", "y=\"1.2\">" + sensors + "</robot>");
        String plan = "<worlds><scenario file=\"room.xml\"/></worlds><masks sensors=\"%s\"/>";
        String sixteen = SamplePlan.text("", String.format(plan, String.join(" ", ids.subList(0, 16))));
        assertEquals(1 << 16, SamplePlan.read(sixteen, room).runCount());
        String seventeen = SamplePlan.text("", String.format(plan, String.join(" ", ids)));
        ScenarioException refusal = assertThrows(ScenarioException.class, () -> SamplePlan.read(seventeen, room));
        assertEquals(1, refusal.problems().size());
        String problem = refusal.problems().get(0).message().toString();
        assertTrue(problem.startsWith("sensors of <masks> is \"s0 s1 "), problem);
        assertTrue(problem.endsWith("; expected at most 16 of them"), problem);
    }
}
