package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The rear goes first if no trusted sensor looks ahead or faces the wall. */
class DriveDirectionTest {

    @ParameterizedTest
    @CsvSource({
        "LEFT, front rear-left, FORWARDS",
        "LEFT, front-left, FORWARDS",
        "LEFT, left rear-left, FORWARDS",
        "LEFT, rear-left front-right, FORWARDS",
        "LEFT, rear-left, BACKWARDS",
        "LEFT, rear-left right, BACKWARDS",
        "LEFT, rear-left rear rear-right right, BACKWARDS",
        "RIGHT, right, FORWARDS",
        "RIGHT, rear-right front-left, FORWARDS",
        "RIGHT, rear-right left, BACKWARDS"
    })
    void theRearGoesFirstIfAllTrustedSensorsLookBack(WallSide side, String on, DriveDirection expected) {
        List<String> trusted = List.of(on.split(" "));
        double[] readings = RobotSpec.DEFAULT.sensors().stream()
                .map(SensorSpec::id)
                .mapToDouble(id -> trusted.contains(id) ? Reading.NOTHING : Reading.OFF)
                .toArray();
        SensorDiagnosis diagnosis = new SensorDiagnosis(side);
        diagnosis.update(new Observation(0, 0.01, RobotSpec.DEFAULT, readings), 0, 0, 1);
        assertEquals(expected, DriveDirection.of(diagnosis));
    }

    @Test
    void backwardsTheRearLeadsAndVelocitiesAreNegative() {
        assertEquals(0.5, DriveDirection.FORWARDS.leading(0.5));
        assertEquals(0.2, DriveDirection.FORWARDS.velocity(0.2));
        assertEquals(0.5 + Math.PI, DriveDirection.BACKWARDS.leading(0.5));
        assertEquals(-0.2, DriveDirection.BACKWARDS.velocity(0.2));
    }
}
