package faultline.scenario;

import faultline.gui.text.Translations;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Scenario files as tests write them: one small valid file, and pieces exchanged in it. */
final class SampleScenario {

    /** Valid, with one thing of each kind. */
    static final String PLAIN =
            """
            <scenario xmlns="urn:faultline:scenario:1" name="Plain">
              <description>One of each.</description>
              <world width="6" height="4" maxMoving="1">
                <rectangle id="desk" x="3" y="3" width="1" height="0.5"/>
                <circle id="pole" x="3" y="1" radius="0.02"/>
                <ellipse id="sofa" x="5" y="2" rx="0.5" ry="0.3"/>
                <polygon id="niche" x="0" y="0" points="2,2 2.5,2 2.5,2.5"/>
                <wall id="screen" x="0" y="0" points="0,3 1,3"/>
                <circle id="visitor" x="5" y="3" radius="0.15">
                  <motion speed="0.2" points="5,3 5,1"/>
                </circle>
              </world>
              <robot x="1" y="1">
                <motor timeConstant="0.05"/>
                <sensor id="left" range="0.6"/>
                <sensor id="probe" x="0.1" y="0" bearing="10"/>
              </robot>
              <controller type="wall-follower" distance="0.25"/>
              <timeline>
                <fault at="10" sensor="front" kind="stuck" value="0.4" until="20"/>
                <mend at="21" sensor="front"/>
                <switch at="30" sensor="left" on="false"/>
                <tune at="31" sensor="left" cone="30"/>
                <move at="40" obstacle="desk" x="3" y="1"/>
                <put at="41"><circle id="extra" x="4" y="1" radius="0.1"/></put>
                <remove at="42" obstacle="extra"/>
                <platform at="43" speed="0.2"/>
              </timeline>
              <expect collision="false"/>
            </scenario>
            """;

    private SampleScenario() {}

    /** Reads a text under the name of room.xml. */
    static Scenario read(String text) throws ScenarioException {
        return read(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Reads a file under the name of room.xml. */
    static Scenario read(byte[] file) throws ScenarioException {
        return ScenarioReader.read("room.xml", file);
    }

    /** Returns the problems of a text as lines, each checked to be translated; empty if the text is valid. */
    static List<String> problems(String text) {
        try {
            read(text);
            return List.of();
        } catch (ScenarioException e) {
            e.problems().forEach(problem -> Translations.assertTranslated(problem.message()));
            return e.problems().stream().map(Problem::toString).toList();
        }
    }

    /** The plain file with one piece exchanged, which must be there. */
    static String withReplacement(String piece, String other) {
        if (!PLAIN.contains(piece)) {
            throw new IllegalArgumentException("the plain file has no " + piece);
        }
        return PLAIN.replace(piece, other);
    }
}
