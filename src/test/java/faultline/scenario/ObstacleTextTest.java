package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ObstacleTextTest {

    private static final List<Obstacle> TWO = List.of(
            new Obstacle("desk", new ObstacleShape.Rectangle(1, 0.5), new Pose(2, 1, 0.1)),
            new Obstacle("visitor", new ObstacleShape.Circle(0.15), new Pose(1, 3, 0),
                    Optional.of(new Motion(0.2, true, List.of(new Vec(1, 3), new Vec(5, 3))))));

    @Test
    void whatIsWrittenReadsBackEqual() throws ScenarioException {
        assertEquals(TWO, ObstacleText.read(ObstacleText.write(TWO)));
    }

    @Test
    void theTextIsWhatAFileHolds() {
        assertEquals("<circle id=\"pole\" x=\"1\" y=\"2\" heading=\"0\" radius=\"0.1\"/>\n",
                ObstacleText.write(List.of(new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(1, 2, 0)))));
    }

    @Test
    void aWholeScenarioGivesItsObstacles() throws Exception {
        Scenario office = Scenario.shipped("office.xml");
        assertEquals(office.setup().world().obstacles(), ObstacleText.read(new String(office.toBytes(), StandardCharsets.UTF_8)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"some words", "<circle id=\"pole\" x=\"1\" y=\"2\" radius=\"-1\"/>", "</world>", "<!DOCTYPE x><circle/>"})
    void whatHoldsNoSoundObstaclesIsRefused(String text) {
        assertThrows(ScenarioException.class, () -> ObstacleText.read(text));
    }
}
