package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Observation;
import faultline.control.SensorFinding;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The diagnosis of a sensor whose cone changes during the run. */
class ReconfiguredSensorTest {

    private static final double DT = 0.01;
    private static final double RANGE = 0.4;
    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;
    private static final int FRONT = ROBOT.indexOf("front");
    private static final SensorSpec FRONT_SENSOR = ROBOT.sensors().get(FRONT);

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private long tick;

    private void observe(RobotSpec robot, double frontReading) {
        double[] readings = new double[robot.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        readings[FRONT] = frontReading;
        diagnosis.update(new Observation(tick, DT, robot, readings), 0, 0, tick == 0 ? 0 : 1);
        tick++;
    }

    private SensorFinding finding() {
        return diagnosis.health().get(FRONT).finding();
    }

    /** A wall just within the range comes and goes with the noise of the readings. */
    private void flicker(RobotSpec robot) {
        for (int i = 0; i < 100; i++) {
            observe(robot, i % 2 == 0 ? RANGE - 0.005 : Reading.NOTHING);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {RANGE, 2 * RANGE})
    void aWallAtTheNewRangeMayComeAndGo(double rangeBefore) {
        for (int i = 0; i < 20; i++) {
            observe(ROBOT.withSensor(FRONT_SENSOR.withRange(rangeBefore)), Reading.NOTHING);
        }
        flicker(ROBOT.withSensor(FRONT_SENSOR.withRange(RANGE)));
        assertEquals(SensorFinding.NONE, finding());
    }

    @Test
    void withinTheRangeItMayNot() {
        flicker(ROBOT);
        assertEquals(SensorFinding.INTERMITTENT, finding());
    }
}
