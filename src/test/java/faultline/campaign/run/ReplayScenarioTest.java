package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.SamplePlan;
import faultline.engine.metrics.Expectation;
import faultline.scenario.Scenario;
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

    /** A run that ends with its verdict is shorter than its scenario; what it is expected to do is not repeated. */
    @Test
    void aReplayLastsAsLongAsItsRunAndExpectsNothing() throws Exception {
        Scenario replay = ReplayScenario.of(plan(), 1, Outcome.COLLIDED, 2.5);
        assertEquals(2.5, replay.setup().duration());
        assertEquals(Expectation.NONE, replay.expectation());
    }
}
