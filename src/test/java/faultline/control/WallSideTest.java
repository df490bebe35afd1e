package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.robot.WheelSpeeds;
import org.junit.jupiter.api.Test;

class WallSideTest {

    @Test
    void theWheelsOnTheSideOfTheWallComeFirst() {
        WheelSpeeds wheels = new WheelSpeeds(0.1, 0.3);
        assertEquals(wheels, WallSide.LEFT.nearAndFar(wheels));
        assertEquals(new WheelSpeeds(0.3, 0.1), WallSide.RIGHT.nearAndFar(wheels));
    }
}
