package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.engine.metrics.Expectation;
import faultline.scenario.Scenario;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** A room that expects no contact, in a plan with two seeds and two speeds, without a fault or with one. */
class ReplayScenarioTest {

    private static final String PLAN = SamplePlan.text(
            "",
            """
            <worlds><scenario file="room.xml"/></worlds><seeds first="7" count="2"/>
            <set attribute="robot/@speed" value="0.2 0.3"/>
            <faults><healthy/><fault sensor="front" kind="off" at="1"/></faults>
            """);

    private static CampaignPlan plan() throws Exception {
        String room = SamplePlan.ROOM.replace("</scenario>", "<expect collision=\"false\"/></scenario>");
        CampaignPlan plan = SamplePlan.read(PLAN, room);
        assertNotEquals(Expectation.NONE, plan.scenario(plan.run(0)).expectation());
        return plan;
    }

    @Test
    void aReplayDescribesItsRun() throws Exception {
        assertEquals(
                "Run 7 of Test: world room, seed 8, robot_speed_m_s 0.3, fault_kind off, fault_sensor front,"
                        + " fault_onset_s 1; outcome lost",
                ReplayScenario.of(plan(), 7, Outcome.LOST, 6).description());
        assertEquals(
                "Run 0 of Test: world room, seed 7, robot_speed_m_s 0.2, fault_kind none; outcome carried_on",
                ReplayScenario.of(plan(), 0, Outcome.CARRIED_ON, 6).description());
    }

    /** The sensors that are on are described in full, as are all other values. */
    @Test
    void aDescriptionThatWouldBeTooLongForAScenarioIsCut() throws Exception {
        String ids =
                IntStream.range(0, 1000).mapToObj(i -> "s" + i + "-".repeat(96)).collect(Collectors.joining(" "));
        String sensors = Stream.of(ids.split(" "))
                .map(id -> "<sensor id=\"" + id + "\" x=\"0\" y=\"0\" bearing=\"0\"/>")
                .collect(Collectors.joining());
        CampaignPlan plan = SamplePlan.read(
                SamplePlan.text(
                        "",
                        "<worlds><scenario file=\"room.xml\"/></worlds><masks sensors=\"" + ids + "\"><mask on=\"" + ids
                                + "\"/></masks>"),
                SamplePlan.ROOM.replace("y=\"1.2\"/>", "y=\"1.2\">" + sensors + "</robot>"));
        Scenario replay = ReplayScenario.of(plan, 0, Outcome.LOST, 6);
        assertEquals(100_000, replay.description().length());
        assertTrue(replay.description().endsWith("...; outcome lost"));
        replay.toBytes();
    }

    /** A run that ends with its verdict is shorter than its scenario; what it is expected to do is not repeated. */
    @Test
    void aReplayLastsAsLongAsItsRunAndExpectsNothing() throws Exception {
        Scenario replay = ReplayScenario.of(plan(), 1, Outcome.COLLIDED, 2.5);
        assertEquals(2.5, replay.setup().duration());
        assertEquals(Expectation.NONE, replay.expectation());
    }
}
