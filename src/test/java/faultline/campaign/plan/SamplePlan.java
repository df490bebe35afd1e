package faultline.campaign.plan;

import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Plans for tests, in which every scenario file is the same small room. */
public final class SamplePlan {

    /** A room in which a robot can be run. */
    public static final String ROOM =
            """
            <scenario xmlns="urn:faultline:scenario:1" name="Room" duration="6">
              <world width="3" height="2"><circle id="pole" x="2" y="0.5" radius="0.1"/></world>
              <robot x="0.6" y="1.2"/>
            </scenario>
            """;

    private SamplePlan() {}

    /** Returns the text of a plan with some elements in it. */
    public static String text(String attributes, String elements) {
        return "<campaign xmlns=\"urn:faultline:campaign:1\" name=\"Test\" " + attributes + ">\n" + elements
                + "\n</campaign>\n";
    }

    /** Reads a plan, whose file is called plan.xml. */
    public static CampaignPlan read(String text) throws ScenarioException {
        return read(text, ROOM);
    }

    /** Reads a plan, whose file is called plan.xml and whose scenario files are all the same room. */
    public static CampaignPlan read(String text, String room) throws ScenarioException {
        return PlanReader.read(
                "plan.xml",
                text.getBytes(StandardCharsets.UTF_8),
                (number, name) -> room.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the problems of a plan with a room and some elements, one per line. */
    static List<String> problems(String elements) {
        return problems("<worlds><scenario file=\"room.xml\"/></worlds>", elements);
    }

    /** Returns the problems of a plan with some worlds and, from line 3 on, some other elements. */
    static List<String> problems(String worlds, String elements) {
        try {
            read(text("", worlds + "\n" + elements));
            return List.of();
        } catch (ScenarioException e) {
            return e.problems().stream().map(Problem::toString).toList();
        }
    }
}
