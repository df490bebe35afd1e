package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class MotionClockTest {

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);

    /** Lets a robot that sees nothing stand still. */
    private void stand(double seconds) {
        double[] readings = new double[RobotSpec.DEFAULT.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        diagnosis.update(new Observation(1, seconds, RobotSpec.DEFAULT, readings), 0, 0, 1);
    }

    private boolean isUnseenPlaceASurface() {
        return diagnosis.grid().findLastHit(80, 80, diagnosis.now() - 700, 1 << diagnosis.sensors(), new int[1]);
    }

    @Test
    void whatWasSeenIsForgottenAfterSomeTime() {
        stand(1);
        diagnosis.markUnseen(80 * EvidenceGrid.CELL, 80 * EvidenceGrid.CELL);
        stand(69);
        assertTrue(isUnseenPlaceASurface());
        stand(2);
        assertFalse(isUnseenPlaceASurface());
    }

    @Test
    void itRunsOnAfterMoreMomentsThanAnIntegerCounts() {
        stand(1);
        diagnosis.markUnseen(80 * EvidenceGrid.CELL, 80 * EvidenceGrid.CELL);
        stand(3e8);
        int before = diagnosis.now();
        stand(1);
        assertEquals(10, diagnosis.now() - before);
        assertFalse(isUnseenPlaceASurface());
    }
}
