package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;

/** The direction that a body keeps beside its heading. */
class RobotBodyTest {

    /** Both zeros are equal as numbers. The sign is part of the bits that equal runs have in common. */
    @Test
    void theSineOfAHeadingOfZeroHasTheSignOfTheZero() {
        RobotBody body = new RobotBody(RobotSpec.DEFAULT, new Pose(0, 0, -0.0));
        assertEquals(-0.0, body.heading());
        assertEquals(-0.0, body.sin());
        body.advance(1);
        assertEquals(0.0, body.heading());
        assertEquals(0.0, body.sin());
    }
}
