package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;

class ObservationTest {

    private static final RobotSpec ROBOT =
            RobotSpec.DEFAULT.withSensors(RobotSpec.DEFAULT.sensors().subList(0, 2));

    private static Observation observation(double front, double frontLeft) {
        return new Observation(0, 0.01, ROBOT, new double[] {front, frontLeft});
    }

    @Test
    void aSensorThatSeesNothingHasTheOtherValue() {
        assertEquals(0.4, observation(0.4, 0.5).distance("front", 9));
        assertEquals(9, observation(Reading.NOTHING, 0.5).distance("front", 9));
        assertEquals(9, observation(0.4, Reading.OFF).distance("front-left", 9));
    }

    @Test
    void aSensorThatTheRobotLacksHasTheOtherValue() {
        assertEquals(9, observation(0.4, 0.5).distance("frontleft", 9));
    }
}
