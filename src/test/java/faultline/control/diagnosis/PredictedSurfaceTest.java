package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.diagnosis.MissedSurfaces.PredictedSurface;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PredictedSurfaceTest {

    @Test
    void itLiesAheadOfTheSensorNotOfTheRobot() {
        RobotSpec prompt = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        DeadReckoning reckoning = new DeadReckoning();
        reckoning.advance(prompt, 3, 3, 0.01, 100);
        reckoning.advance(prompt, -1, 1, 0.01, 80);
        MountedCone cone = new MountedCone(0.1, 0.03, 0, 0.1, 0.8);
        double heading = 0.8 * 0.2 / 0.18;
        PredictedSurface surface = PredictedSurface.ahead(reckoning, cone, 0.4);
        assertEquals(0.3 + 0.5 * Math.cos(heading) - 0.03 * Math.sin(heading), surface.x(), 1e-9);
        assertEquals(0.5 * Math.sin(heading) + 0.03 * Math.cos(heading), surface.y(), 1e-9);
        assertEquals(Math.cos(heading), surface.cos(), 1e-9);
        assertEquals(Math.sin(heading), surface.sin(), 1e-9);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.6, 1.5708, 2.5, 4})
    void itIsRefutedIfAllPlacesFromFiveCentimetresBeforeToFifteenBehindAreFree(double direction) {
        double cos = Math.cos(direction);
        double sin = Math.sin(direction);
        PredictedSurface surface = new PredictedSurface(1, -0.5, cos, sin);
        for (double gap = -0.05; gap < 0.149; gap += 0.025) {
            EvidenceGrid grid = new EvidenceGrid(2);
            int column = EvidenceGrid.cellOf(1 + gap * cos);
            int row = EvidenceGrid.cellOf(-0.5 + gap * sin);
            for (double along = -0.05; along < 0.149; along += 0.0025) {
                double x = 1 + along * cos;
                double y = -0.5 + along * sin;
                if (EvidenceGrid.cellOf(x) != column || EvidenceGrid.cellOf(y) != row) {
                    markCell(grid, x, y);
                }
            }
            assertFalse(surface.isRefuted(grid, 5, 3), "not seen at " + gap);
            markCell(grid, 1 + gap * cos, -0.5 + gap * sin);
            assertTrue(surface.isRefuted(grid, 5, 3), "seen at " + gap);
            assertFalse(surface.isRefuted(grid, 6, 3), "too long ago");
            assertFalse(surface.isRefuted(grid, 5, 1), "by another sensor");
        }
    }

    private static void markCell(EvidenceGrid grid, double x, double y) {
        double centreX = (EvidenceGrid.cellOf(x) + 0.5) * EvidenceGrid.CELL;
        double centreY = (EvidenceGrid.cellOf(y) + 0.5) * EvidenceGrid.CELL;
        grid.markDisc(1, centreX, centreY, 0.014, 5);
    }
}
