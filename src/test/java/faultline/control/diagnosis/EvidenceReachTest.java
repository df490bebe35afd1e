package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EvidenceReachTest {

    /** The distances that the robot rolls while evidence counts in an inspection and in the local map, metres. */
    private static final double INSPECTION_ROLL = 0.7;

    private static final double MAP_ROLL = 1;

    private static SensorDiagnosis diagnosis(double wantedDistance) {
        SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
        setWantedDistance(diagnosis, wantedDistance);
        double[] readings = new double[RobotSpec.DEFAULT.sensors().size()];
        Arrays.fill(readings, 0.7);
        diagnosis.update(new Observation(0, 0.01, RobotSpec.DEFAULT, readings), 0, 0, 1);
        return diagnosis;
    }

    /** Sets the reading that the left sensor shall have, which is mounted 0.1 m from the centre. */
    private static void setWantedDistance(SensorDiagnosis diagnosis, double wantedDistance) {
        diagnosis.setWantedDistance(
                wantedDistance,
                robot -> wantedDistance
                        + robot.sensor("left").orElseThrow().mountPosition().y());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.25, 0.5, 0.8})
    void theDefaultRobotNeedsTheLeastReachUpToAWantedDistanceOfEightTenths(double wantedDistance) {
        assertEquals(EvidenceReach.LEAST, diagnosis(wantedDistance).reach());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.9, 0.91, 1.3, 1.7, 2})
    void noTwoPlacesWithinTheReachShareACell(double centreDistance) {
        EvidenceReach reach = EvidenceReach.of(centreDistance);
        double wrap = reach.gridSize() * EvidenceGrid.CELL;
        double window = reach.windowSize() / 2 * EvidenceGrid.CELL;
        assertTrue(reach.holdsWanted());
        assertTrue(window >= centreDistance, "the wall is in the window");
        assertTrue(2 * reach.distance() + INSPECTION_ROLL <= wrap);
        assertTrue(window + reach.distance() + MAP_ROLL <= wrap);
        assertEquals(1, Integer.bitCount(reach.gridSize()));
    }

    @Test
    void aWallThatIsTooFarAwayNeedsNoMoreThanTheLeastReach() {
        EvidenceReach reach = EvidenceReach.of(2.001);
        assertFalse(reach.holdsWanted());
        assertEquals(EvidenceReach.LEAST.gridSize(), reach.gridSize());
        assertEquals(EvidenceReach.LEAST.windowSize(), reach.windowSize());
        assertFalse(EvidenceReach.of(Double.POSITIVE_INFINITY).holdsWanted());
    }

    @Test
    void evidenceIsForgottenOnlyIfTheReachChanges() {
        SensorDiagnosis diagnosis = diagnosis(0.5);
        diagnosis.markUnseen(0.3, 0.2);
        setWantedDistance(diagnosis, 0.7);
        assertTrue(isMarked(diagnosis));
        setWantedDistance(diagnosis, 1.5);
        assertFalse(isMarked(diagnosis));
        diagnosis.markUnseen(0.3, 0.2);
        assertTrue(isMarked(diagnosis));
    }

    private static boolean isMarked(SensorDiagnosis diagnosis) {
        int column = EvidenceGrid.cellOf(0.3);
        int row = EvidenceGrid.cellOf(0.2);
        return diagnosis.grid().isHit(column, row, 1, 1 << diagnosis.sensors());
    }
}
