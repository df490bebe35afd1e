package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ObstacleXmlTest {

    private static final List<Obstacle> TWO_OBSTACLES = List.of(
            new Obstacle("desk", new ObstacleShape.RectangleShape(1, 0.5), new Pose(2, 1, 0.1)),
            new Obstacle(
                    "visitor",
                    new ObstacleShape.CircleShape(0.15),
                    new Pose(1, 3, 0),
                    new WaypointPath(0.2, true, List.of(new Vector2(1, 3), new Vector2(5, 3)))));

    @Test
    void whatIsWrittenReadsBackEqual() throws ScenarioException {
        assertEquals(TWO_OBSTACLES, ObstacleXml.parse(ObstacleXml.format(TWO_OBSTACLES)));
    }

    @Test
    void theTextIsWhatAFileHolds() {
        assertEquals(
                "<circle id=\"pole\" x=\"1\" y=\"2\" heading=\"0\" radius=\"0.1\"/>\n",
                ObstacleXml.format(
                        List.of(new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1, 2, 0)))));
    }

    @Test
    void aWholeScenarioGivesItsObstacles() throws Exception {
        Scenario office = Scenario.loadShipped("office.xml");
        assertEquals(
                office.setup().world().obstacles(),
                ObstacleXml.parse(new String(office.toBytes(), StandardCharsets.UTF_8)));
    }

    @Test
    void aScenarioOrElementsCanBeginWithComments() throws Exception {
        String room =
                """
                <!-- My room --><!-- <scenario> -->

                <scenario xmlns="urn:faultline:scenario:1" name="Room" duration="6">
                  <world width="3" height="2"><circle id="pole" x="2" y="0.5" radius="0.1"/></world>
                  <robot x="0.6" y="1.2"/>
                </scenario>
                """;
        assertEquals("pole", ObstacleXml.parse(room).get(0).id());
        String pole = "<!-- One --> <!-- pole --><circle id=\"pole\" x=\"2\" y=\"0.5\" radius=\"0.1\"/>";
        assertEquals(ObstacleXml.parse(room), ObstacleXml.parse(pole));
        assertEquals(List.of(), ObstacleXml.parse("<!---->".repeat(1000)));
    }

    @Test
    void aTextCanBeginWithAByteOrderMark() throws Exception {
        String pole = "<circle id=\"pole\" x=\"2\" y=\"0.5\" radius=\"0.1\"/>";
        assertEquals(ObstacleXml.parse(pole), ObstacleXml.parse("\uFEFF" + pole));
        String office = new String(Scenario.loadShipped("office.xml").toBytes(), StandardCharsets.UTF_8);
        assertEquals(ObstacleXml.parse(office), ObstacleXml.parse("\uFEFF" + office));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "some words",
                "<!-- a comment without an end",
                "<circle id=\"pole\" x=\"1\" y=\"2\" radius=\"-1\"/>",
                "</world>",
                "<!DOCTYPE x><circle/>"
            })
    void textWithoutValidObstaclesIsRefused(String text) {
        assertThrows(ScenarioException.class, () -> ObstacleXml.parse(text));
    }

    @ParameterizedTest
    @ValueSource(strings = {"<circle id=", "desks & chairs", "</world>"})
    void aMistakeIsDescribedByTheTextAlone(String text) {
        String message = assertThrows(ScenarioException.class, () -> ObstacleXml.parse(text))
                .problems()
                .get(0)
                .toString();
        assertFalse(message.contains("maxMoving"), message);
    }

    @Test
    void aTextWithADoctypeIsNotCalledAFile() {
        ScenarioException refused = assertThrows(
                ScenarioException.class, () -> ObstacleXml.parse("<?xml version=\"1.0\"?><!DOCTYPE x><x/>"));
        assertTrue(refused.getMessage().endsWith("this has a DOCTYPE; expected none"), refused.getMessage());
    }
}
