package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RandomRoom;
import faultline.campaign.RoomRules;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.GainRule;
import faultline.control.Thresholds;
import faultline.control.WallSide;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class CampaignPlanTest {

    private static final String WORLDS =
            "<worlds><scenario file=\"a.xml\"/><scenario file=\"b.xml\"/></worlds><seeds first=\"5\" count=\"3\"/>";

    private static CampaignPlan plan(String elements) throws ScenarioException {
        return SamplePlan.read(SamplePlan.text("sampling=\"latin\"", WORLDS + elements));
    }

    @Test
    void everyLevelIsCombinedWithEveryOtherInEveryBlock() throws ScenarioException {
        CampaignPlan plan = plan(
                """
                <set attribute="robot/sensor[front]/@cone" value="5 10"/>
                <faults><healthy/><fault sensor="front left" kind="off" at="1"/></faults>
                """);
        assertEquals(2 * 3 * 2 * 3, plan.runCount());
        Set<List<String>> different = new HashSet<>();
        LongStream.range(0, plan.runCount())
                .mapToObj(plan::run)
                .forEach(run -> different.add(List.of(run.world(), run.seed() + "", run.cells() + "")));
        assertEquals(36, different.size());
        assertEquals(List.of("10", "off", "left", "", "1", ""), plan.run(35).cells());
        assertEquals(
                List.of("10", "off", "front", "", "1", ""), plan.run(4).cells(), "the last factor changes fastest");
        assertEquals("b", plan.run(35).world());
        assertEquals(7, plan.run(35).seed());
    }

    @Test
    void theColumnsOfFaultsEndWithTheirUnits() throws ScenarioException {
        CampaignPlan plan = plan(
                "<faults><fault sensor=\"front\" kind=\"bursts\" value=\"2\" length=\"0.1 0.3\" at=\"1\"/></faults>");
        assertEquals(
                List.of(
                        "fault_kind",
                        "fault_sensor",
                        "fault_value",
                        "fault_onset_s s",
                        "fault_end_s s",
                        "fault_length_s s"),
                plan.factorColumns().stream()
                        .map(column -> (column.name() + " " + column.unit()).strip())
                        .toList());
        assertEquals("0.3", plan.run(1).cells().get(5));
    }

    @Test
    void aRoomCanHaveAnotherTypeOfController() throws ScenarioException {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text(
                "", "<worlds><rooms/></worlds><set attribute=\"controller/@type\" value=\"wall-follower none\"/>"));
        assertEquals(
                ControllerSpec.WallFollowing.DEFAULT,
                plan.scenario(plan.run(0)).setup().controller());
        assertEquals(
                new ControllerSpec.None(), plan.scenario(plan.run(1)).setup().controller());
    }

    private static final String RIGHT_HAND =
            "<controller type=\"wall-follower\" distance=\"0.3\" hand=\"right\" period=\"0.02\"/></scenario>";

    private static CampaignPlan planOfTypes(String controller, String sets) throws ScenarioException {
        String room = SamplePlan.ROOM.replace("</scenario>", controller);
        return SamplePlan.read(SamplePlan.text("", WORLDS + sets), room);
    }

    @Test
    void anotherTypeOfControllerLacksTheAttributesOfTheFile() throws ScenarioException {
        String types = "<set attribute=\"controller/@type\" value=\"wall-follower none drive\"/>";
        CampaignPlan plan = planOfTypes(RIGHT_HAND, types);
        ControllerSpec own = new ControllerSpec.WallFollowing(
                0.3,
                WallSide.RIGHT,
                0.02,
                ControllerSpec.WallFollowing.DEFAULT.timingRule(),
                true,
                GainRule.AUTOMATIC,
                Thresholds.DEFAULT);
        assertEquals(own, plan.scenario(plan.run(0)).setup().controller());
        assertEquals(
                new ControllerSpec.None(), plan.scenario(plan.run(1)).setup().controller());
        assertEquals(
                new ControllerSpec.Drive(0, 0),
                plan.scenario(plan.run(2)).setup().controller());
        String recorded =
                "<controller type=\"recorded\" ticks=\"9\"><decisions>1,1*9</decisions></controller></scenario>";
        CampaignPlan replaced = planOfTypes(recorded, "<set attribute=\"controller/@type\" value=\"wall-follower\"/>");
        assertEquals(
                ControllerSpec.WallFollowing.DEFAULT,
                replaced.scenario(replaced.run(0)).setup().controller());
    }

    private static List<Expectation.Condition> conditions(CampaignPlan plan, int run) throws ScenarioException {
        return plan.scenario(plan.run(run)).expectation().conditions();
    }

    @Test
    void anotherTypeOfControllerIsNotExpectedToReachTheStatesOfTheFile() throws ScenarioException {
        String types = "<set attribute=\"controller/@type\" value=\"wall-follower none drive\"/>";
        String expect = "<expect collision=\"false\" states=\"SEARCH FOLLOW\" finalState=\"FOLLOW\"/></scenario>";
        Expectation.Condition collision = new Expectation.Collides(false);
        for (String controller : List.of("", "<controller distance=\"0.3\"/>")) {
            CampaignPlan plan = planOfTypes(controller + expect, types);
            assertEquals(4, conditions(plan, 0).size());
            assertEquals(List.of(collision), conditions(plan, 1));
            assertEquals(List.of(collision), conditions(plan, 2));
        }
        String later = "<timeline><controller at=\"1\" type=\"drive\"/></timeline>";
        String both = "<expect states=\"SEARCH DRIVE\"/></scenario>";
        CampaignPlan plan = planOfTypes(later + both, "<set attribute=\"controller/@type\" value=\"none\"/>");
        assertEquals(List.of(new Expectation.VisitedState(ControllerState.of("DRIVE"))), conditions(plan, 0));
    }

    @Test
    void statesThatThePlanItselfExpectsOfAnotherTypeAreReported() {
        String none = "<set attribute=\"controller/@type\" value=\"none\"/>";
        String states = "<set attribute=\"expect/@finalState\" value=\"FOLLOW\"/>";
        ScenarioException refusal = assertThrows(
                ScenarioException.class,
                () -> planOfTypes("<expect states=\"SEARCH\" finalState=\"SEARCH\"/></scenario>", none + states));
        assertEquals(
                List.of("finalState of <expect> is \"FOLLOW\"; expected one of the controller's states: NONE (in a)"),
                refusal.problems().stream()
                        .map(problem -> problem.message().toString())
                        .toList());
    }

    @Test
    void whatThePlanItselfSetsOfAnotherTypeIsReported() {
        String none = "<set attribute=\"controller/@type\" value=\"none\"/>";
        String distance = "<set attribute=\"controller/@distance\" value=\"0.2\"/>";
        ScenarioException refusal =
                assertThrows(ScenarioException.class, () -> planOfTypes(RIGHT_HAND, none + distance));
        assertEquals(
                List.of("<controller> has no attribute \"distance\"; expected type (in a)"),
                refusal.problems().stream()
                        .map(problem -> problem.message().toString())
                        .toList());
    }

    @Test
    void roomsHaveConsecutiveNumbers() throws ScenarioException {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds><rooms first=\"5\" count=\"2\"/></worlds>"));
        for (int index = 0; index < 2; index++) {
            RandomRoom room = RandomRoom.ofSeed(5 + index, RoomRules.DEFAULT);
            Scenario scenario = plan.scenario(plan.run(index));
            assertEquals("room-" + (5 + index), plan.run(index).world());
            assertEquals(room.start(), scenario.setup().start());
            assertEquals(room.world(), scenario.setup().world());
        }
    }

    @Test
    void aPlanNamesTheControllersThatDriveItsRobots() throws ScenarioException {
        assertEquals(List.of("wall-follower"), plan("").controllerTypes());
        assertEquals(
                List.of("none"),
                plan("<set attribute=\"controller/@type\" value=\"none\"/>").controllerTypes());
        assertEquals(
                List.of("wall-follower"),
                plan("<set attribute=\"controller/@distance\" value=\"0.2 0.3\"/>")
                        .controllerTypes());
        assertEquals(
                List.of("drive", "none"),
                plan("<set attribute=\"controller/@type\" value=\"any of drive none\"/>")
                        .controllerTypes());
        String variants =
                """
                <variants><variant name="own"/>
                <variant name="still"><set attribute="controller/@type" value="none"/></variant></variants>
                """;
        String drive = SamplePlan.ROOM.replace("</scenario>", "<controller type=\"drive\"/></scenario>");
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", WORLDS + variants), drive);
        assertEquals(List.of("drive", "none"), plan.controllerTypes());
        assertEquals(
                List.of("wall-follower", "none"),
                SamplePlan.read(SamplePlan.text("", "<worlds><rooms count=\"2\"/></worlds>" + variants))
                        .controllerTypes());
    }

    /** A file for a controller from outside can be run with the controllers of the program. */
    @Test
    void aFactorReplacesAControllerFromOutside() throws ScenarioException {
        String scenario = SamplePlan.ROOM.replace("</scenario>", "<controller type=\"extern\"/></scenario>");
        String plan = SamplePlan.text(
                "",
                """
                <worlds><scenario file="room.xml"/></worlds>
                <set attribute="@duration" value="1 2"/>
                <set attribute="controller/@type" value="none drive"/>
                """);
        PlanFiles.Resolver resolver = (number, name) -> scenario.getBytes(StandardCharsets.UTF_8);
        byte[] bytes = plan.getBytes(StandardCharsets.UTF_8);
        assertEquals(4, PlanReader.read("plan.xml", bytes, resolver).runCount());
        byte[] without = plan.replaceFirst("<set .*type.*>", "").getBytes(StandardCharsets.UTF_8);
        ScenarioException refusal =
                assertThrows(ScenarioException.class, () -> PlanReader.read("plan.xml", without, resolver));
        assertEquals(
                "the controller is from outside, which no plan can name; expected one of the program or of --jar"
                        + " (in room)",
                refusal.problems().get(0).message().toString());
    }

    @Test
    void allRunsOfABlockHaveTheSameWorldSeedAndDraws() throws ScenarioException {
        CampaignPlan plan = plan(
                """
                <set attribute="robot/@speed" value="0.1..0.3"/>
                <variants><variant name="default"/><variant name="far">
                  <set attribute="controller/@distance" value="0.3"/></variant></variants>
                """);
        assertEquals(6 * 2, plan.runCount());
        Set<Double> speeds = new HashSet<>();
        for (long run = 0; run < plan.runCount(); run += 2) {
            SimulationSetup original = plan.scenario(plan.run(run)).setup();
            SimulationSetup far = plan.scenario(plan.run(run + 1)).setup();
            assertEquals(original.robot(), far.robot());
            assertEquals(original.seed(), far.seed());
            assertTrue(!original.controller().equals(far.controller()));
            speeds.add(original.robot().speed());
        }
        assertEquals(6, speeds.size());
    }

    private static final String FIFTY_SPEEDS =
            """
            <worlds><scenario file="a.xml"/></worlds>
            <seeds count="50"/>
            <set attribute="robot/@speed" value="0.1..0.2"/>
            """;

    /** Returns how many fiftieths of the range the speeds of fifty blocks are in. */
    private static long drawnParts(String attributes) throws ScenarioException {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text(attributes, FIFTY_SPEEDS));
        return LongStream.range(0, plan.runCount())
                .mapToDouble(run -> Double.parseDouble(plan.run(run).cells().get(0)))
                .mapToLong(speed -> (long) ((speed - 0.1) / 0.1 * 50))
                .distinct()
                .count();
    }

    /** Independent draws are in all parts with a probability of 50! / 50^50, which is 3e-21. */
    @Test
    void aLatinHypercubeIsDrawnOnRequestOnly() throws ScenarioException {
        assertEquals(50, drawnParts("sampling=\"latin\""));
        assertTrue(drawnParts("sampling=\"random\"") < 50);
        assertTrue(drawnParts("") < 50);
    }

    @Test
    void allSeedsAndTheirNumberAreOneByDefault() throws ScenarioException {
        String world = "<worlds><scenario file=\"a.xml\"/></worlds>";
        String drawn = "<set attribute=\"robot/@speed\" value=\"0.1..0.2\"/>";
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", world + "<seeds/>" + drawn));
        assertEquals(1, plan.runCount());
        assertEquals(1, plan.run(0).seed());
        assertEquals(
                SamplePlan.read(SamplePlan.text("seed=\"1\"", world + drawn)).run(0), plan.run(0));
    }

    @Test
    void theDescriptionHasNoBlanksAroundIt() throws ScenarioException {
        String description = "<description>\n  Two\n  lines\n</description>";
        assertEquals("Two\n  lines", plan(description).header().description());
    }

    @Test
    void aRunEndsAtItsVerdictOnRequestOnly() throws ScenarioException {
        assertTrue(SamplePlan.read(SamplePlan.text("end=\"verdict\"", FIFTY_SPEEDS))
                .header()
                .untilVerdict());
        for (String attributes : List.of("end=\"duration\"", "")) {
            assertFalse(SamplePlan.read(SamplePlan.text(attributes, FIFTY_SPEEDS))
                    .header()
                    .untilVerdict());
        }
    }

    @Test
    void aFaultIsAddedToTheTimelineOfItsRun() throws ScenarioException {
        CampaignPlan plan =
                plan("<faults><fault sensor=\"left\" kind=\"stuck\" value=\"0.2\" at=\"1..3\" lasts=\"2\"/></faults>");
        Scenario scenario = plan.scenario(plan.run(4));
        List<SimulationSetup.TimedCommand> timeline = scenario.setup().timeline();
        assertEquals(2, timeline.size());
        assertTrue(timeline.get(0).command() instanceof Command.InjectFault);
        assertEquals(2, timeline.get(1).time() - timeline.get(0).time(), 1e-9);
        assertEquals(
                timeline.get(0).time(), Double.parseDouble(plan.run(4).cells().get(3)));
    }

    @Test
    void aMaskNamesSensorsWhoseIdsHaveBlanks() throws ScenarioException {
        String room = SamplePlan.ROOM.replace(
                "<robot x=\"0.6\" y=\"1.2\"/>",
                """
                <robot x="0.6" y="1.2">
                  <sensor id="left" x="0" y="0.1" bearing="90"/>
                  <sensor id="front nose" x="0.1" y="0" bearing="0"/>
                </robot>
                """);
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        "<worlds><scenario file=\"a.xml\"/></worlds><masks sensors='left \"front nose\"'>"
                                + "<mask on=''/><mask on='\"front nose\"'/><mask on='\"front nose\" left'/></masks>"),
                room);
        assertEquals(3, plan.runCount());
        assertEquals(List.of("none", "0"), plan.run(0).cells());
        assertEquals(List.of("\"front nose\"", "1"), plan.run(1).cells());
        assertEquals(List.of("\"front nose\" left", "2"), plan.run(2).cells());
        RobotSpec robot = plan.scenario(plan.run(1)).setup().robot();
        assertTrue(robot.sensor("front nose").orElseThrow().on());
        assertFalse(robot.sensor("left").orElseThrow().on());
    }

    @Test
    void aFaultWithoutALabelIsCalledByItsKind() throws ScenarioException {
        CampaignPlan plan = plan(
                """
                <faults><healthy/><fault sensor="front" kind="off" at="1"/>
                <fault sensor="front" kind="stuck" value="0.5" at="1" label="frozen"/></faults>
                """);
        List<String> columns = plan.factorColumns().stream().map(Column::name).toList();
        assertEquals(
                List.of("none", "off", "frozen"),
                LongStream.range(0, 3)
                        .mapToObj(run -> plan.run(run).cells().get(columns.indexOf("fault_label")))
                        .toList());
    }

    @Test
    void aFaultMayBeOfASensorWhoseIdHasABlank() throws ScenarioException {
        String room = SamplePlan.ROOM.replace(
                "y=\"1.2\"/>", "y=\"1.2\"><sensor id=\"front nose\" x=\"0.1\" y=\"0\" bearing=\"0\"/></robot>");
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        "<worlds><scenario file=\"a.xml\"/></worlds>"
                                + "<faults><fault sensor='\"front nose\" left' kind=\"off\" at=\"1\"/></faults>"),
                room.replace("></robot>", "><sensor id=\"left\" x=\"0\" y=\"0.1\" bearing=\"90\"/></robot>"));
        assertEquals("front nose", plan.run(0).cells().get(1));
        assertEquals("left", plan.run(1).cells().get(1));
    }

    /** "none" is a legal id. */
    @Test
    void theSetOfASensorThatIsCalledNoneIsNotThatOfNoSensors() throws ScenarioException {
        String room = SamplePlan.ROOM.replace(
                "y=\"1.2\"/>",
                "y=\"1.2\"><sensor id=\"none\" x=\"0.1\" y=\"0\" bearing=\"0\"/>"
                        + "<sensor id=\"left\" x=\"0\" y=\"0.1\" bearing=\"90\"/></robot>");
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text("", "<worlds><scenario file=\"a.xml\"/></worlds><masks sensors=\"none left\"/>"), room);
        assertEquals(
                List.of("none", "\"none\"", "left", "none left"),
                LongStream.range(0, 4)
                        .mapToObj(run -> plan.run(run).cells().get(0))
                        .toList());
    }

    @Test
    void masksAreAllSubsetsOfTheSensors() throws ScenarioException {
        CampaignPlan plan = plan("<masks/>");
        assertEquals(6 * 256, plan.runCount());
        SimulationSetup setup = plan.scenario(plan.run(5)).setup();
        assertEquals(List.of("front left", "2"), plan.run(5).cells());
        assertEquals(
                List.of("front", "left"),
                setup.robot().sensors().stream()
                        .filter(sensor -> sensor.on())
                        .map(sensor -> sensor.id())
                        .toList());
    }

    @Test
    void aValueThatNeverVariesIsNoColumn() throws ScenarioException {
        CampaignPlan plan = plan("<set attribute=\"@duration\" value=\"9\"/>");
        assertEquals(List.of(), plan.factorColumns());
        assertEquals(9, plan.scenario(plan.run(0)).setup().duration());
    }

    @Test
    void roomsAreGeneratedBySeed() throws ScenarioException {
        CampaignPlan plan = SamplePlan.read(SamplePlan.text("", "<worlds><rooms first=\"10\" count=\"3\"/></worlds>"));
        assertEquals("room-12", plan.run(2).world());
        assertEquals(plan.scenario(plan.run(2)), plan.scenario(plan.run(2)));
    }
}
