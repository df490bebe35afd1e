package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Observation;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Two sensors at one place that contradict only each other. */
class JumpedSensorTest {

    private static final double DT = 0.01;
    private static final SensorSpec NARROW = RobotSpec.DEFAULT.sensors().get(0);
    private static final SensorSpec WIDE = NARROW.withId("wide").withCone(2 * NARROW.cone());

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private long tick;

    private void observe(RobotSpec robot, int ticks, double... readings) {
        for (int i = 0; i < ticks; i++) {
            diagnosis.update(new Observation(tick, DT, robot, readings), 0, 0, tick == 0 ? 0 : 1);
            tick++;
        }
    }

    /** Far sooner than if neither had jumped. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theOneWhoseReadingJumpedIsNotTrusted(boolean wideJumps) {
        RobotSpec robot = RobotSpec.DEFAULT.withSensors(List.of(NARROW, WIDE));
        observe(robot, 100, 0.3, 0.3);
        // What the wide one sees free, or does not, is all that the narrow one sees.
        observe(robot, 40, wideJumps ? 0.3 : 0.2, wideJumps ? 0.5 : 0.3);
        SensorFinding wide = wideJumps ? SensorFinding.CONTRADICTED : SensorFinding.NONE;
        SensorFinding narrow = wideJumps ? SensorFinding.NONE : SensorFinding.CONTRADICTED;
        assertEquals(
                List.of(narrow, wide),
                diagnosis.health().stream().map(SensorHealth::finding).toList());
    }
}
