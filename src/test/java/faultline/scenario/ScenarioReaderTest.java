package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What valid files come to. */
class ScenarioReaderTest {

    /** The example of the format's first description, word for word. */
    private static final String FIRST_EXAMPLE =
            """
            <scenario xmlns="urn:faultline:scenario:1" name="Room" duration="120" tick="0.01" seed="1">
              <description>A room with one of each obstacle.</description>
              <world width="6" height="4" enclosed="true" maxMoving="3">   <!-- origin at the lower left corner -->
                <rectangle id="desk" x="2" y="1" heading="30" width="1" height="0.5"/>   <!-- x, y: its centre -->
                <circle    id="pole" x="3" y="2" radius="0.02"/>
                <ellipse   id="sofa" x="4" y="3" heading="0" rx="0.5" ry="0.3"/>
                <polygon   id="niche" x="0" y="0" heading="0" points="1,1 2,1 2,2"/>     <!-- closed; local coordinates -->
                <wall      id="partition" x="0" y="0" heading="0" points="0,3 2,3 2,4"/> <!-- open polyline, no thickness -->
                <circle    id="visitor" x="1" y="3" radius="0.15">
                  <motion speed="0.2" loop="true" points="1,3 5,3"/>   <!-- waypoints of the shape's origin; at most maxMoving (3) -->
                </circle>
              </world>
              <robot x="%s" y="1" heading="0" length="0.25" width="0.20" track="0.18" speed="0.3" turnRate="60">
                <motor timeConstant="0.05" speedConstant="0.1" maxVoltage="6"/>          <!-- speedConstant: m/s per volt -->
                <sensor id="left" x="0" y="0.1" bearing="90" range="0.8" cone="20" on="true" noise="0.0"/>
              </robot>
              <controller type="wall-follower" distance="0.25"/>   <!-- type="none": the robot stays; "drive" with left/right volts -->
              <timeline>
                <fault   at="10" sensor="front" kind="stuck" value="0.4" until="20"/>
                <switch  at="30" sensor="left" on="false"/>
                <move    at="40" obstacle="desk" x="3" y="1" heading="45"/>
              </timeline>
              <expect collision="false" minCoverage="0.9"/>
            </scenario>
            """;

    @Test
    void aFileLargeEnoughToBeValidatedOnAnotherThreadReadsLikeASmallOne() throws ScenarioException {
        String small = FIRST_EXAMPLE.formatted("0.5");
        String large = small.replace("</description>", "</description><!--" + " ".repeat(1 << 20) + "-->");
        assertEquals(SampleScenario.read(small), SampleScenario.read(large));
        assertEquals(
                SampleScenario.problems(small.replace("sofa", "desk")),
                SampleScenario.problems(large.replace("sofa", "desk")));
    }

    @Test
    void theFirstExampleOfTheFormatReadsAsItStandsButForTheRobotThatTouchesTheNiche() throws ScenarioException {
        assertEquals(
                List.of("room.xml:13:100: <robot> starts at 1,1 where it touches or overlaps "
                        + "\"niche\"; expected a place with room for "
                        + "the whole platform"),
                SampleScenario.problems(FIRST_EXAMPLE.formatted("1")));
        Scenario scenario = SampleScenario.read(FIRST_EXAMPLE.formatted("0.5"));
        SimulationSetup setup = scenario.setup();
        assertEquals("Room", scenario.name());
        assertEquals(RobotSpec.DEFAULT, setup.robot());
        assertEquals(new Pose(0.5, 1, 0), setup.start());
        assertEquals(
                new Obstacle(
                        "visitor",
                        new ObstacleShape.CircleShape(0.15),
                        new Pose(1, 3, 0),
                        new WaypointPath(0.2, true, List.of(new Vector2(1, 3), new Vector2(5, 3)))),
                setup.world().obstacles().get(5));
        assertEquals(
                List.of(
                        new TimedCommand(10, new Command.InjectFault("front", new Fault.Stuck(0.4))),
                        new TimedCommand(20, new Command.ClearFault("front", new Fault.Stuck(0.4))),
                        new TimedCommand(30, new Command.SwitchSensor("left", false)),
                        new TimedCommand(40, new Command.MoveObstacle("desk", new Pose(3, 1, Degrees.toRadians(45))))),
                setup.timeline());
        assertEquals(
                new Expectation(List.of(new Expectation.Collides(false), new Expectation.MinCoverage(0.9))),
                scenario.expectation());
    }

    @Test
    void aFileThatSaysOnlyWhatItMustHasTheDocumentedDefaults() throws ScenarioException {
        Scenario scenario = SampleScenario.read(
                """
                <scenario xmlns="urn:faultline:scenario:1"><robot x="1" y="2"/><world width="6" height="4"/></scenario>
                """);
        WorldSpec world = new WorldSpec(6, 4, true, 3, List.of());
        SimulationSetup setup = SimulationSetup.of(world, new Pose(1, 2, 0));
        assertEquals(new Scenario("", "", false, setup, Expectation.NONE), scenario);
        assertEquals(MotorSpec.DEFAULT, scenario.setup().robot().motor());
    }

    @Test
    void aStandardSensorIsSetInItsPlaceAndAnyOtherComesAfterTheEight() throws ScenarioException {
        List<SensorSpec> sensors =
                SampleScenario.read(SampleScenario.PLAIN).setup().robot().sensors();
        List<SensorSpec> standard = RobotSpec.standardSensors(0.25, 0.2);
        assertEquals(9, sensors.size());
        assertEquals(standard.get(2).withRange(0.6), sensors.get(2));
        assertEquals(
                new SensorSpec(
                        "probe", new Vector2(0.1, 0), Degrees.toRadians(10), 0.8, Degrees.toRadians(20), true, 0),
                sensors.get(8));
    }

    @Test
    void withoutTheDefaultSensorsOnlyTheListedOnesAreThere() throws ScenarioException {
        Scenario scenario = SampleScenario.read(
                """
                <scenario xmlns="urn:faultline:scenario:1"><world width="6" height="4"/>
                <robot x="1" y="2" defaultSensors="false"><sensor id="eye" x="0" y="0" bearing="0"/></robot></scenario>
                """);
        assertEquals(
                List.of("eye"),
                scenario.setup().robot().sensors().stream().map(SensorSpec::id).toList());
    }

    @Test
    void theMountPositionsOfTheStandardSensorsFollowThePlatform() throws ScenarioException {
        Scenario scenario = SampleScenario.read(SampleScenario.withReplacement(
                "<robot x=\"1\" y=\"1\">", "<robot x=\"1\" y=\"1\" length=\"0.5\" width=\"0.4\">"));
        assertEquals(
                new Vector2(0, 0.2),
                scenario.setup().robot().sensor("left").orElseThrow().mountPosition());
    }

    @Test
    void everyKindOfTimelineElementBecomesItsCommand() throws ScenarioException {
        SensorSpec left = RobotSpec.DEFAULT.sensors().get(2).withRange(0.6);
        List<TimedCommand> timeline =
                SampleScenario.read(SampleScenario.PLAIN).setup().timeline();
        assertEquals(
                List.of(
                        new TimedCommand(10, new Command.InjectFault("front", new Fault.Stuck(0.4))),
                        new TimedCommand(20, new Command.ClearFault("front", new Fault.Stuck(0.4))),
                        new TimedCommand(21, new Command.ClearFaults("front")),
                        new TimedCommand(30, new Command.SwitchSensor("left", false)),
                        new TimedCommand(31, new Command.ConfigureSensor(left.withCone(Degrees.toRadians(30)))),
                        new TimedCommand(40, new Command.MoveObstacle("desk", new Pose(3, 1, 0))),
                        new TimedCommand(
                                41,
                                new Command.PlaceObstacle(
                                        new Obstacle("extra", new ObstacleShape.CircleShape(0.1), new Pose(4, 1, 0)))),
                        new TimedCommand(42, new Command.RemoveObstacle("extra")),
                        new TimedCommand(43, new Command.SetPlatform(0.25, 0.2, 0.2))),
                timeline);
    }

    @Test
    void aTuneSwitchesASensorAsItSaysAndOtherwiseAsTheRobotElementDoes() throws ScenarioException {
        String tunes =
                """
                <timeline>
                    <tune at="0.01" sensor="left" on="false"/>
                    <tune at="0.02" sensor="left" range="0.7"/>
                    <switch at="0.03" sensor="probe" on="false"/>
                    <tune at="0.04" sensor="probe" range="0.7"/>
                    <tune at="0.05" sensor="probe" on="false"/>
                """;
        Scenario scenario = SampleScenario.read(SampleScenario.withReplacement("<timeline>", tunes));
        List<String> off = new ArrayList<>();
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            for (int tick = 1; tick <= 5; tick++) {
                simulation.tick();
                off.add(simulation.robot().sensors().stream()
                        .filter(sensor -> !sensor.on())
                        .map(SensorSpec::id)
                        .collect(Collectors.joining()));
            }
        }
        assertEquals(List.of("left", "", "probe", "", "probe"), off);
    }

    @Test
    void anObstacleMayHaveASingleWaypoint() throws ScenarioException {
        assertEquals(
                new WaypointPath(0.2, true, List.of(new Vector2(5, 3))),
                SampleScenario.read(SampleScenario.withReplacement("5,3 5,1", "5,3"))
                        .setup()
                        .world()
                        .obstacles()
                        .get(5)
                        .motion());
    }

    @Test
    void everyTypeOfControllerIsRead() throws ScenarioException {
        String plain = "<controller type=\"wall-follower\" distance=\"0.25\"/>";
        assertEquals(
                ControllerSpec.WallFollowing.DEFAULT
                        .withDistance(0.3)
                        .withSide(WallSide.RIGHT)
                        .withPeriod(0.02)
                        .withTimingRule(TimingRule.RANGE),
                controller(SampleScenario.withReplacement(
                        plain, "<controller distance=\"0.3\" hand=\"right\" period=\"0.02\" timing=\"range\"/>")));
        assertEquals(
                new ControllerSpec.Drive(2, -1.5),
                controller(SampleScenario.withReplacement(
                        plain, "<controller type=\"drive\" left=\"2\" right=\"-1.5\"/>")));
        assertEquals(
                new ControllerSpec.Drive(0, 0),
                controller(SampleScenario.withReplacement(plain, "<controller type=\"drive\"/>")));
        assertEquals(
                new ControllerSpec.None(),
                controller(SampleScenario.withReplacement(plain, "<controller type=\"none\"/>")));
    }

    @Test
    void eachOfSixtyExpectedStatesIsReadAlone() throws ScenarioException {
        List<String> names = IntStream.range(0, 60).mapToObj(i -> "S" + i).toList();
        Scenario scenario = SampleScenario.read(
                """
                <scenario xmlns="urn:faultline:scenario:1"><robot x="1" y="2"/><world width="6" height="4"/>
                <controller type="extern"/><expect states="%s"/></scenario>
                """
                        .formatted(String.join(" ", names)));
        assertEquals(
                names.stream()
                        .map(name -> new Expectation.VisitedState(ControllerState.of(name)))
                        .toList(),
                scenario.expectation().conditions());
    }

    @Test
    void expectedStatesAreCheckedWithoutARobot() {
        String scenario =
                """
                <scenario xmlns="urn:faultline:scenario:1"><world width="6" height="4"/>
                <controller type="none"/><timeline>%s</timeline><expect states="FOLLOW"/></scenario>
                """;
        assertEquals(2, SampleScenario.problems(scenario.formatted("")).size());
        assertEquals(
                1,
                SampleScenario.problems(scenario.formatted("<controller at=\"2\" type=\"wall-follower\"/>"))
                        .size());
    }

    private static final String LATE_FOLLOWER =
            """
            <scenario xmlns="urn:faultline:scenario:1"><robot x="1" y="2"/><world width="6" height="4"/>
            <controller type="none"/><timeline><controller at="2" type="wall-follower" diagnosis="off"/></timeline>
            <expect states="NONE FOLLOW" finalState="%s"/></scenario>
            """;

    @Test
    void statesOfControllersOfTheTimelineMayBeExpected() throws ScenarioException {
        assertEquals(
                List.of(
                        new Expectation.VisitedState(ControllerState.of("NONE")),
                        new Expectation.VisitedState(ControllerState.of("FOLLOW")),
                        new Expectation.FinalState(ControllerState.of("ROUND"))),
                SampleScenario.read(LATE_FOLLOWER.formatted("ROUND"))
                        .expectation()
                        .conditions());
        List<String> problems = SampleScenario.problems(LATE_FOLLOWER.formatted("DRIVE"));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(
                problems.get(0).endsWith("states: NONE, SEARCH, TURN, MEASURE, ALIGN, FOLLOW, ROUND"),
                problems::toString);
    }

    @Test
    void withoutARobotTheTimelineIsNotKnownAndNoStateIsRefused() {
        List<String> problems =
                SampleScenario.problems(LATE_FOLLOWER.formatted("ROUND").replace("<robot x=\"1\" y=\"2\"/>", ""));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("robot"), problems::toString);
    }

    @ParameterizedTest
    @ValueSource(strings = {"states=\"\"", "states=\" \"", "finalState=\"\"", "finalState=\" \""})
    void anExpectedStateOfAnyControllerHasAName(String attribute) {
        List<String> problems = SampleScenario.problems(
                """
                <scenario xmlns="urn:faultline:scenario:1"><robot x="1" y="2"/><world width="6" height="4"/>
                <controller type="extern"/><expect %s/></scenario>
                """
                        .formatted(attribute));
        assertEquals(1, problems.size(), problems::toString);
        assertTrue(problems.get(0).contains("the name of a state"), problems::toString);
    }

    @Test
    void aControllerFromOutsideIsMeasuredByTheDistanceOfTheFile() throws ScenarioException {
        String plain = "<controller type=\"wall-follower\" distance=\"0.25\"/>";
        assertEquals(
                new ControllerSpec.Extern(0.02, 0.3),
                controller(SampleScenario.withReplacement(
                        plain, "<controller type=\"extern\" period=\"0.02\" distance=\"0.3\"/>")));
        assertEquals(
                OptionalDouble.of(0.25),
                controller(SampleScenario.withReplacement(plain, "<controller type=\"extern\"/>"))
                        .wantedDistance());
    }

    private static ControllerSpec controller(String text) throws ScenarioException {
        return SampleScenario.read(text).setup().controller();
    }

    @Test
    void aSchemaLocationAttributeIsIgnored() {
        assertEquals(
                List.of(),
                SampleScenario.problems(SampleScenario.withReplacement(
                        "name=\"Plain\"",
                        "name=\"Plain\" "
                                + "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
                                + "xsi:schemaLocation=\"urn:faultline:scenario:1 scenario-1.xsd\"")));
    }

    @Test
    void whiteSpaceAboutNumbersAndInTheDescriptionDoesNotMatter() throws ScenarioException {
        Scenario scenario =
                SampleScenario.read(SampleScenario.withReplacement("One of each.", "\n   One\n\t of  each.\n")
                        .replace("x=\"1\"", "x=\" 1 \""));
        assertEquals("One of each.", scenario.description());
        assertEquals(1, scenario.setup().start().x());
    }

    @Test
    void theShippedScenariosAreInTheProgram() {
        ScenarioException missing = org.junit.jupiter.api.Assertions.assertThrows(
                ScenarioException.class, () -> Scenario.loadShipped("none.xml"));
        assertEquals("none.xml: the program contains no such scenario", missing.getMessage());
        assertTrue(missing.problems().get(0).location().equals(SourceLocation.NONE));
    }
}
