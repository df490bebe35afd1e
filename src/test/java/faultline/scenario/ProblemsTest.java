package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerProviders;
import faultline.scenario.xml.ScenarioException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The sentence for each mistake in a file, word for word. */
class ProblemsTest {

    @ParameterizedTest(name = "{1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            # Numbers
            width="6"          | width="-6"         | 3:46: width of <world> is "-6"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="six"        | 3:47: width of <world> is "six"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="NaN"        | 3:47: width of <world> is "NaN"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="INF"        | 3:47: width of <world> is "INF"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="1e999"      | 3:49: width of <world> is "1e999"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="6,0"        | 3:47: width of <world> is "6,0"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="0x1p3"      | 3:49: width of <world> is "0x1p3"; expected a number from 0.000001 to 100000 metres
            width="6"          | width="6d"         | 3:46: width of <world> is "6d"; expected a number from 0.000001 to 100000 metres
            width="6"          | width=""           | 3:44: width of <world> is ""; expected a number from 0.000001 to 100000 metres
            name="Plain"       | tick="0"           | 1:53: tick of <scenario> is "0"; expected a number from 0.00001 to 1 seconds
            name="Plain"       | seed="1.5"         | 1:55: seed of <scenario> is "1.5"; expected a whole number from -9223372036854775808 to 9223372036854775807
            name="Plain"       | duration="1e8"     | 1:59: duration of <scenario> is "1e8"; expected a number from 0 to 10000000 seconds
            maxMoving="1"      | maxMoving="-1"     | 3:46: maxMoving of <world> is "-1"; expected a whole number from 0 to 100000
            range="0.6"        | cone="180"         | 15:35: cone of <sensor> is "180"; expected a number without exponent, more than 0 and less than 180 degrees
            range="0.6"        | cone="0"           | 15:33: cone of <sensor> is "0"; expected a number without exponent, more than 0 and less than 180 degrees
            range="0.6"        | cone="179.99999999999999999999" | 15:56: cone of <sensor> is "179.99999999999999999999"; expected a number without exponent, more than 0 and less than 180 degrees
            range="0.6"        | bearing="1e1"      | 15:38: bearing of <sensor> is "1e1"; expected a number without exponent, from -1000000 to 1000000 degrees
            range="0.6"        | bearing="1E1"      | 15:38: bearing of <sensor> is "1E1"; expected a number without exponent, from -1000000 to 1000000 degrees
            <robot x="1" y="1" | <robot x="1" y="1" speed="0"      | 13:32: speed of <robot> is "0"; expected a number more than 0 and at most 1000 metres per second
            <robot x="1" y="1" | <robot x="1" y="1" speed="1e-400" | 13:37: speed of <robot> is "1e-400"; expected a number more than 0 and at most 1000 metres per second
            # Words
            on="false"         | on="no"            | 22:44: on of <switch> is "no"; expected true, false
            kind="stuck"       | kind="stick"       | 20:72: kind of <fault> is "stick"; expected off, stuck, bias, dropout, stuck-at-last, scale, drift, noise, quantised, bursts, delayed, short-range and 5 more; did you mean "stuck"?
            kind="stuck"       | kind="Stuck"       | 20:72: kind of <fault> is "Stuck"; expected off, stuck, bias, dropout, stuck-at-last, scale, drift, noise, quantised, bursts, delayed, short-range and 5 more; did you mean "stuck"?
            kind="stuck"       | kind="off"         | 20:70: value of <fault> is "0.4"; expected none, because a fault of kind off takes no value
            sensor="front"     | motor="port"       | 20:70: motor of <fault> is "port"; expected left, right
            sensor="front" kind="stuck" | motor="left" kind="stuck" | 20:70: kind of <fault> is "stuck"; expected weak, dead, dead-band
            sensor="front" kind="stuck" value="0.4" | motor="left" kind="weak" value="1.4" | 20:69: value of <fault> is "1.4"; expected a number from 0 to 1
            sensor="front" kind="stuck" | motor="left" kind="dead"  | 20:69: value of <fault> is "0.4"; expected none, because a fault of kind dead takes no value
            sensor="front" kind="stuck" value="0.4" | motor="left" sensor="front" kind="dead" | 20:72: <fault> has no attribute "sensor"; expected at, until, motor, kind, value
            <fault at="10" sensor="front" kind="stuck" | <fault at="10" kind="stuck" | 20:57: <fault> lacks the attribute "sensor"; expected 1 to 100 characters, none of them a comma, a double quote or a control character
            value="0.4"        | value="-0.4"       | 20:73: value of <fault> is "-0.4"; expected a number from 0 to 100 metres
            "wall-follower"    | "wall-folower"     | 18:52: type of <controller> is "wall-folower"; expected wall-follower, none, drive, extern, recorded or a controller in Java from --jar; did you mean "wall-follower"?
            distance="0.25"    | left="2"           | 18:46: <controller> has no attribute "left"; expected type, distance, hand, period, timing, diagnosis, gains, aheadMargin, turnClearance, timingLevel, settledRate, lostMargin and 4 more
            collision="false"  | states="FOLOW"     | 29:27: states of <expect> is "FOLOW"; expected one of the controller's states: SEARCH, TURN, MEASURE, ALIGN, FOLLOW, ROUND, STOP; did you mean "FOLLOW"?
            collision="false"  | finalState="NONE"  | 29:30: finalState of <expect> is "NONE"; expected one of the controller's states: SEARCH, TURN, MEASURE, ALIGN, FOLLOW, ROUND, STOP
            collision="false"  | minCoverage="90"   | 29:29: minCoverage of <expect> is "90"; expected a number from 0 to 1
            # Elements and attributes
            <circle id="pole"  | <circel id="pole"  | 5:50: <world> must not contain <circel>; expected rectangle, circle, ellipse, polygon, wall, plan; did you mean "circle"?
            <motor             | <engine            | 14:34: <robot> must not contain <engine>; expected motor, sensor
            <mend at="21"      | <heal at="21"      | 21:35: <timeline> must not contain <heal>; expected fault, mend, switch, tune, move, put, remove, platform, controller
            radius="0.02"      | radus="0.02"       | 5:49: <circle> has no attribute "radus"; expected id, x, y, heading, radius; did you mean "radius"?
            <motor timeConstant="0.05"/> | <motor/><motor/>    | 14:21: <robot> contains a second <motor>; expected one
            <description>One of each.</description> | <robot x="1" y="1"/> | 13:22: <scenario> contains a second <robot>; expected one
            <motion speed="0.2" points="5,3 5,1"/> | <motor/> | 10:15: <circle> must not contain <motor>; expected motion
            <motion speed="0.2" points="5,3 5,1"/> | <motion speed="0.2" points="5,3 5,1"/><motion speed="0" points="5,3"/> | 10:77: <circle> contains a second <motion>; expected one
            <motion speed="0.2" points="5,3 5,1"/> | <motion speed="0.2" points="5,3 5,1"><stop/></motion> | 10:51: <motion> must not contain <stop>; expected nothing
            <controller type="wall-follower" distance="0.25"/> | <controller type="wall-follower"><lens/></controller> | 18:43: <controller> must not contain <lens>; expected nothing
            <expect collision="false"/> | <expect collision="false"><lens/></expect> | 29:36: <expect> must not contain <lens>; expected nothing
            <description>      | <description lang="en"> | 2:26: <description> has no attribute "lang"; expected none
            <remove at="42" obstacle="extra"/> | <remove at="42" obstacle="extra"><circle/></remove> | 26:47: <remove> must not contain <circle>; expected nothing
            <circle id="extra" x="4" y="1" radius="0.1"/> | <motor/> | 25:18: <put> contains 0 obstacles; expected one of rectangle, circle, ellipse, polygon, wall, plan
            <circle id="extra" x="4" y="1" radius="0.1"/> | <circle id="extra" x="4" y="1" radius="0.1"/><circle id="two" x="5" y="1" radius="0.1"/> | 25:18: <put> contains 2 obstacles; expected one of rectangle, circle, ellipse, polygon, wall, plan
            One of each.       | One <b/> each.     | 2:24: <description> must not contain <b>; expected text
            <motor timeConstant="0.05"/> | text              | 13:22: <robot> contains the text "text"; expected elements only: motor, sensor
            # Points
            2,2 2.5,2 2.5,2.5  | 2,2 2.5,2          | 7:57: points of <polygon> is "2,2 2.5,2"; expected 3 or more points as x,y with blanks between them, each number from -100000 to 100000 metres
            2,2 2.5,2 2.5,2.5  | 2,2 2.5;2 2.5,2.5  | 7:65: points of <polygon> is "2.5;2"; expected 3 or more points as x,y with blanks between them, each number from -100000 to 100000 metres
            0,3 1,3            | 0,3                | 8:49: points of <wall> is "0,3"; expected 2 or more points as x,y with blanks between them, each number from -100000 to 100000 metres
            # Ids
            id="pole"          | id="enclosure"     | 5:55: id of <circle> is "enclosure"; expected another id, because this is the name of the wall around the world
            id="pole"          | id="desk"          | 5:50: id of <circle> is "desk", which the element in line 4 already has; expected unique ids
            id="pole"          | id=""              | 5:46: id of <circle> is ""; expected 1 to 100 characters, none of them a comma, a double quote or a control character
            id="pole"          | id="a,b"           | 5:49: id of <circle> is "a,b"; expected 1 to 100 characters, none of them a comma, a double quote or a control character
            id="pole"          | id="a&quot;b"      | 5:54: id of <circle> is "a"b"; expected 1 to 100 characters, none of them a comma, a double quote or a control character
            id="pole"          | id="a&#9;b"        | 5:52: id of <circle> is "a b"; expected 1 to 100 characters, none of them a comma, a double quote or a control character
            id="left" range    | id="lft" range     | 15:35: <sensor> "lft" lacks x, y and bearing; expected these attributes for a new sensor, or one of front, front-left, left, rear-left, rear, rear-right, right, front-right, probe; did you mean "left"?
            id="probe"         | id="left"          | 16:51: id of <sensor> is "left", which the element in line 15 already has; expected unique ids
            sensor="front"     | sensor="frnt"      | 20:71: sensor of <fault> is "frnt"; expected one of the robot's sensors: front, front-left, left, rear-left, rear, rear-right, right, front-right, probe; did you mean "front"?
            obstacle="desk"    | obstacle="desc"    | 24:48: obstacle of <move> is "desc"; expected one of the obstacles: desk, pole, sofa, niche, screen, visitor, extra; did you mean "desk"?
            <circle id="extra" | <circle id="enclosure" | 25:67: id of <circle> is "enclosure"; expected another id, because this is the name of the wall around the world
            # Sense
            until="20"         | until="10"         | 20:72: until of <fault> is 10; expected a time after at, which is 10
            maxMoving="1"      | maxMoving="0"      | 9:52: <circle> "visitor" is moving obstacle number 1; expected at most 0 (maxMoving of <world>)
            points="5,3 5,1"   | points="5,3 5,3.00001" | 10:51: the loop of <motion> takes 0.0001 s; expected 0.01 s or more
            points="5,3 5,1"   | points="5,3 5,3.0009999" | 10:53: the loop of <motion> takes 0.009999 s; expected 0.01 s or more
            <motor timeConstant="0.05"/> | <motor><gear/></motor> | 14:19: <motor> must not contain <gear>; expected nothing
            <sensor id="left" range="0.6"/> | <sensor id="left"><lens/></sensor> | 15:30: <sensor> must not contain <lens>; expected nothing
            timeConstant="0.05"| speedConstant="200" | 14:33: <motor> drives its wheels at up to 1200 m/s (speedConstant times maxVoltage); expected 1000 m/s or less
            timeConstant="0.05"| speedConstant="100" leftScale="0.5" rightScale="2" | 14:64: <motor> drives its wheels at up to 1200 m/s (speedConstant times maxVoltage); expected 1000 m/s or less
            <robot x="1" y="1" | <robot x="1" y="1" track="0.000015" trackScale="0.5" | 13:56: <robot> could spin at 160000 rad/s (twice the maximum wheel speed divided by the track); expected 100000 rad/s or less
            <robot x="1" y="1" | <robot x="1" y="1" track="0.000001" | 13:39: <robot> could spin at 1200000 rad/s (twice the maximum wheel speed divided by the track); expected 100000 rad/s or less
            timeConstant="0.05"| speedConstant="166.67" | 14:36: <motor> drives its wheels at up to 1000.02 m/s (speedConstant times maxVoltage); expected 1000 m/s or less
            <robot x="1" y="1" | <robot x="1" y="1" track="0.000011999" | 13:42: <robot> could spin at 100010 rad/s (twice the maximum wheel speed divided by the track); expected 100000 rad/s or less
            <robot x="1"       | <robot x="6.5"     | 13:24: <robot> starts at 6.5,1 outside of the enclosed world; expected x from 0 to 6 and y from 0 to 4
            <robot x="1"       | <robot x="6"       | 13:22: <robot> starts at 6,1 where it touches or overlaps "enclosure"; expected a place with room for the whole platform
            <robot x="1"       | <robot x="-0"      | 13:23: <robot> starts at -0,1 where it touches or overlaps "enclosure"; expected a place with room for the whole platform
            <robot x="1"       | <robot x="0.1"     | 13:24: <robot> starts at 0.1,1 where it touches or overlaps "enclosure"; expected a place with room for the whole platform
            <robot x="1"       | <robot x="3"       | 13:22: <robot> starts at 3,1 where it touches or overlaps "pole"; expected a place with room for the whole platform
            """)
    void oneMistakeIsReportedInOneSentence(String piece, String other, String problem) {
        List<String> problems = SampleScenario.problems(SampleScenario.withReplacement(piece, other));
        assertEquals("room.xml:" + problem, problems.isEmpty() ? "none" : problems.get(0));
    }

    /** They may be those that it needs. */
    @Test
    void theElementsOfAnUnknownControllerAreNotReported() {
        String unknown = "<controller type=\"mine\"><setting name=\"a\" value=\"b\"/></controller>";
        List<String> problems = SampleScenario.problems(
                SampleScenario.withReplacement("<controller type=\"wall-follower\" distance=\"0.25\"/>", unknown));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("type of <controller> is \"mine\""), problems::toString);
    }

    @Test
    void aMisspeltAttributeThatIsRequiredIsReportedOnce() {
        assertEquals(
                1,
                SampleScenario.problems(SampleScenario.withReplacement("radius=\"0.02\"", "radus=\"0.02\""))
                        .size());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            at="5" until="1O"   | until of <fault> is "1O"; expected a number from 0 to 10000000 seconds
            at="O" until="0.5"  | at of <fault> is "O"; expected a number from 0 to 10000000 seconds
            at="5" until="-1"   | until of <fault> is "-1"; expected a number from 0 to 10000000 seconds
            until="0.5"         | <fault> lacks the attribute "at"; expected a number from 0 to 10000000 seconds
            at="5" until="5"    | until of <fault> is 5; expected a time after at, which is 5
            """)
    void aTimeThatIsNoNumberIsReportedOnce(String times, String problem) {
        List<String> problems = SampleScenario.problems(SampleScenario.withReplacement(
                "<fault at=\"10\" sensor=\"front\" kind=\"stuck\" value=\"0.4\" until=\"20\"/>",
                "<fault sensor=\"front\" kind=\"off\" " + times + "/>"));
        assertEquals(
                List.of(problem),
                problems.stream()
                        .map(line -> line.replaceFirst("^room.xml:\\d+:\\d+: ", ""))
                        .toList());
    }

    @Test
    void noControllerInJavaCanHaveTheNameOfATypeThatTheFormatDefines() {
        String problem = SampleScenario.problems(SampleScenario.withReplacement("\"wall-follower\"", "\"?\""))
                .get(0);
        String types = problem.replaceAll(".*expected | or a controller.*", "");
        assertEquals(ControllerProviders.BUILT_IN_NAMES, Set.of(types.split(", ")));
    }

    @Test
    void aNameHasUpToTenThousandCharacters() {
        for (int length : new int[] {10_000, 10_001}) {
            String name = "name=\"" + "n".repeat(length) + "\"";
            assertEquals(
                    length - 10_000,
                    SampleScenario.problems(SampleScenario.withReplacement("name=\"Plain\"", name))
                            .size());
        }
    }

    @Test
    void anIdHasUpTo100Characters() {
        for (int length : new int[] {100, 101}) {
            assertEquals(
                    length - 100,
                    SampleScenario.problems(
                                    SampleScenario.withReplacement("id=\"pole\"", "id=\"" + "p".repeat(length) + "\""))
                            .size());
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            <decisions>1,1*10</decisions><decisions from="9">2,2</decisions>   | from of <decisions> is "9"; expected a whole number from 10 to 9007199254740992
            <decisions from="3">1,1*10 2,2</decisions><decisions>2,2</decisions> | <decisions> lacks the attribute "from"; expected a whole number from 14 to 9007199254740992
            <decisions from="3">1,1</decisions><decisions from="-1"/>          | from of <decisions> is "-1"; expected a whole number from 4 to 9007199254740992
            <decisions>1,1*10</decisions><decisions from="10">2,2</decisions><decisions from="20"/> | none
            <decisions from="9223372036854775807">1,1</decisions>              | from of <decisions> is "9223372036854775807"; expected a whole number from 0 to 9007199254740992
            <decisions from="9007199254740992">1,1</decisions>                 | decisions of <decisions> is "1,1"; expected decisions that end at tick 9007199254740992 or earlier
            <decisions from="2">1,1 2,2*9007199254740990 3,3</decisions>       | decisions of <decisions> is "2,2*9007199254740990"; expected decisions that end at tick 9007199254740992 or earlier
            <decisions from="1">1,1 2,2*9007199254740990</decisions>           | none
            <decisions frm="3">1,1</decisions>                                 | <decisions> has no attribute "frm"; expected from, state, why; did you mean "from"?
            """)
    void decisionsAreInOrderAndEndInTime(String decisions, String problem) {
        List<String> problems = SampleScenario.problems(SampleScenario.withReplacement(
                "<controller type=\"wall-follower\" distance=\"0.25\"/>",
                "<controller type=\"recorded\" ticks=\"5\">" + decisions + "</controller>"));
        List<String> sentences = problems.stream()
                .map(line -> line.replaceFirst("^room.xml:\\d+:\\d+: ", ""))
                .toList();
        assertEquals(problem.equals("none") ? List.of() : List.of(problem), sentences);
    }

    @Test
    void aRecordEndsInTime() {
        assertEquals(List.of(), problemsOfTicks("9007199254740992"));
        assertEquals(
                List.of("room.xml:18:57: ticks of <controller> is \"9007199254740993\";"
                        + " expected a whole number from 0 to 9007199254740992"),
                problemsOfTicks("9007199254740993"));
    }

    private static List<String> problemsOfTicks(String ticks) {
        return SampleScenario.problems(SampleScenario.withReplacement(
                "<controller type=\"wall-follower\" distance=\"0.25\"/>",
                "<controller type=\"recorded\" ticks=\"" + ticks + "\"/>"));
    }

    @Test
    void anElementAmongDecisionsIsReported() throws ScenarioException {
        String text =
                """
                <scenario xmlns="urn:faultline:scenario:1">
                  <world width="6" height="4"/>
                  <robot x="1" y="1"/>
                  <controller type="recorded" ticks="5">
                    <decisions>1,1*2 <wait/> 2,2*3</decisions>
                  </controller>
                </scenario>
                """;
        ScenarioException e = assertThrows(
                ScenarioException.class, () -> ScenarioReader.read("a.xml", text.getBytes(StandardCharsets.UTF_8)));
        assertEquals("a.xml:5:29: <decisions> must not contain <wait>; expected text", e.getMessage());
    }

    @Test
    void allProblemsAreReportedTogetherInFileOrder() {
        String text =
                """
                <scenario xmlns="urn:faultline:scenario:1" duration="long">
                  <robot x="1" y="one" colour="red"/>
                  <world width="6">
                    <circle id="pole" x="3" y="3" radius="0"/>
                  </world>
                  <timeline>
                    <switch at="-1" sensor="lft"/>
                  </timeline>
                </scenario>
                """;
        assertEquals(
                List.of(
                        "room.xml:1:60: duration of <scenario> is \"long\"; expected "
                                + "a number from 0 to 10000000 seconds",
                        "room.xml:2:38: y of <robot> is \"one\"; expected a number from -100000 to 100000 metres",
                        "room.xml:2:38: <robot> has no attribute \"colour\"; expected x, y, heading, "
                                + "length, width, track, trackScale, speed, turnRate, defaultSensors",
                        "room.xml:3:20: <world> lacks the attribute \"height\"; expected "
                                + "a number from 0.000001 to 100000 metres",
                        "room.xml:4:47: radius of <circle> is \"0\"; expected a "
                                + "number from 0.000001 to 100000 metres",
                        "room.xml:7:35: at of <switch> is \"-1\"; expected a number from 0 to 10000000 seconds",
                        "room.xml:7:35: sensor of <switch> is \"lft\"; expected one of the robot's "
                                + "sensors: front, front-left, left, rear-left, rear, "
                                + "rear-right, right, front-right; did you mean \"left\"?",
                        "room.xml:7:35: <switch> lacks the attribute \"on\"; expected true or false"),
                SampleScenario.problems(text));
    }

    @Test
    void aFileWithoutWorldAndRobotLacksBoth() {
        assertEquals(
                List.of(
                        "room.xml:1:45: <scenario> lacks the element <world>; expected one",
                        "room.xml:1:45: <scenario> lacks the element <robot>; expected one"),
                SampleScenario.problems("<scenario xmlns=\"urn:faultline:scenario:1\"/>"));
    }

    @Test
    void atMostAHundredProblemsAreReported() {
        String many = SampleScenario.withReplacement(
                "<circle id=\"pole\" x=\"3\" y=\"1\" radius=\"0.02\"/>", "<b/>".repeat(1000));
        List<String> problems = SampleScenario.problems(many);
        assertEquals(101, problems.size());
        assertEquals("room.xml: more problems: 900", problems.get(100));
    }

    @Test
    void theNumberOfFurtherProblemsIsGivenIfThereAreAny() {
        String piece = "<circle id=\"pole\" x=\"3\" y=\"1\" radius=\"0.02\"/>";
        List<String> hundred = SampleScenario.problems(SampleScenario.withReplacement(piece, "<b/>".repeat(100)));
        assertEquals(100, hundred.size());
        assertTrue(hundred.stream().noneMatch(problem -> problem.contains("more problems")), hundred::toString);
        List<String> more = SampleScenario.problems(SampleScenario.withReplacement(piece, "<b/>".repeat(101)));
        assertEquals("room.xml: more problems: 1", more.get(100));
    }

    @Test
    void aLongOrUnprintableValueIsCutAndKeptOnOneLine() {
        String hostile =
                SampleScenario.withReplacement("id=\"pole\"", "id=\"&#10;&#133;[2J" + "x".repeat(100_000) + "\"");
        List<String> problems = SampleScenario.problems(hostile);
        assertTrue(problems.get(0).contains("id of <circle> is \"  [2Jxxx"), problems.get(0));
        assertTrue(problems.get(0).length() < 250 && problems.get(0).lines().count() == 1, problems.get(0));
    }

    @ParameterizedTest
    @CsvSource({"pl", "de", "ja", "ar", "tr"})
    void theSentencesDoNotDependOnTheLanguageOfTheMachine(String language) {
        Locale before = Locale.getDefault();
        String wrong =
                SampleScenario.withReplacement("width=\"6\"", "width=\"-6.5\"").replace("</world>", "<a/></world>");
        String malformed = SampleScenario.PLAIN.replace("</robot>", "");
        List<String> plain = List.of(
                SampleScenario.problems(wrong).toString(),
                SampleScenario.problems(malformed).toString());
        try {
            Locale.setDefault(Locale.forLanguageTag(language));
            assertEquals(
                    plain,
                    List.of(
                            SampleScenario.problems(wrong).toString(),
                            SampleScenario.problems(malformed).toString()));
        } finally {
            Locale.setDefault(before);
        }
    }
}
