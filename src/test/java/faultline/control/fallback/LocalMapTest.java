package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.EvidenceGrid;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LocalMapTest {

    private static final double CELL = EvidenceGrid.CELL;
    private static final int MEMORY = 10_000;
    private static final RobotSpec BLIND =
            RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6)).withSensors(List.of());

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private final LocalMap map = new LocalMap();

    private void drive(RobotSpec robot, double left, double right, int ticks) {
        double[] readings = new double[robot.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        for (int i = 0; i < ticks; i++) {
            diagnosis.update(new Observation(i, 0.01, robot, readings), left, right, 1);
        }
    }

    /** Returns the centre of a cell at some number of cells from that of the robot. */
    private double x(int cells) {
        return (EvidenceGrid.cellOf(diagnosis.reckoning().x()) + cells + 0.5) * CELL;
    }

    private double y(int cells) {
        return (EvidenceGrid.cellOf(diagnosis.reckoning().y()) + cells + 0.5) * CELL;
    }

    private void refresh() {
        map.refresh(diagnosis, MEMORY, 0.1);
    }

    /** The length of the shortest path of straight steps of 5 and diagonal steps of 7, in metres. */
    private static double chamfer(int dx, int dy) {
        int most = Math.max(Math.abs(dx), Math.abs(dy));
        int least = Math.min(Math.abs(dx), Math.abs(dy));
        return (5 * (most - least) + 7 * least) * CELL / 5;
    }

    @Test
    void distancesAreThoseToTheNearestOfTheSurfaces() {
        SplittableRandom random = new SplittableRandom(5);
        drive(BLIND, 2, 2, 50);
        int[][] surfaces = new int[6][];
        for (int i = 0; i < surfaces.length; i++) {
            surfaces[i] = new int[] {random.nextInt(-33, 33), random.nextInt(-33, 33)};
            diagnosis.markUnseen(x(surfaces[i][0]), y(surfaces[i][1]));
        }
        refresh();
        for (int row = -34; row < 34; row++) {
            for (int column = -34; column < 34; column++) {
                double least = Double.POSITIVE_INFINITY;
                for (int[] surface : surfaces) {
                    least = Math.min(least, chamfer(column - surface[0], row - surface[1]));
                }
                assertEquals(least, map.toSurface(x(column), y(row)), 1e-9, column + ", " + row);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.7, 1.6, -2.5})
    void onTheLeftAndAheadOnlyTheSurfacesThereCount(double direction) {
        SplittableRandom random = new SplittableRandom(7);
        drive(BLIND, 2, 2, 50);
        double cos = Math.cos(direction);
        double sin = Math.sin(direction);
        for (int i = 0; i < 200; i++) {
            int[] surface = {random.nextInt(-33, 33), random.nextInt(-33, 33)};
            LocalMapTest alone = new LocalMapTest();
            alone.drive(BLIND, 2, 2, 50);
            alone.diagnosis.markUnseen(x(surface[0]), y(surface[1]));
            alone.refresh();
            int[] from = {random.nextInt(-20, 20), random.nextInt(-20, 20)};
            int dx = surface[0] - from[0];
            int dy = surface[1] - from[1];
            double left = (dy * cos - dx * sin) * CELL;
            boolean counts = left >= 0 || left > -0.1 && dx * cos + dy * sin > 0;
            double distance = alone.map.toSurfaceOnLeft(x(from[0]), y(from[1]), cos, sin, 0.1);
            if (counts) {
                assertEquals(alone.map.toSurface(x(from[0]), y(from[1])), distance, 1e-9, dx + ", " + dy);
            } else {
                assertTrue(distance > 10, dx + ", " + dy);
            }
        }
        assertEquals(0, map.toSurfaceOnLeft(x(40), y(0), cos, sin, 0.1), "outside of the window");
    }

    @Test
    void withoutSurfacesEverythingInTheWindowIsFarAwayAndOutsideIsASurface() {
        drive(BLIND, 2, 2, 50);
        refresh();
        for (int[] inside : new int[][] {{0, 0}, {-36, 0}, {35, 0}, {0, -36}, {0, 35}}) {
            assertTrue(map.toSurface(x(inside[0]), y(inside[1])) > 10, Arrays.toString(inside));
        }
        for (int[] outside : new int[][] {{-37, 0}, {36, 0}, {0, -37}, {0, 36}}) {
            assertEquals(0, map.toSurface(x(outside[0]), y(outside[1])), Arrays.toString(outside));
            assertFalse(map.isKnown(x(outside[0]), y(outside[1])), Arrays.toString(outside));
        }
    }

    @Test
    void theGroundUnderTheRobotIsKnownUnlessASurfaceWasSeenThere() {
        drive(BLIND, 2, 2, 50);
        refresh();
        for (int row = -8; row <= 8; row++) {
            for (int column = -8; column <= 8; column++) {
                boolean own = column * column + row * row <= 16;
                assertEquals(own, map.isKnown(x(column), y(row)), column + ", " + row);
            }
        }
        diagnosis.markUnseen(x(2), y(-1));
        refresh();
        assertFalse(map.isKnown(x(2), y(-1)));
        assertTrue(map.isKnown(x(2), y(1)));
    }

    @Test
    void whatIsOlderThanTheMemoryDoesNotCount() {
        diagnosis.update(new Observation(0, 0.01, BLIND, new double[0]), 0, 0, 1);
        diagnosis.markUnseen(0.5, 0.5);
        refresh();
        assertEquals(0, map.toSurface(0.5, 0.5));
        // The clock runs for one metre: 1000 ticks, and 50 for five seconds.
        drive(BLIND, 2, 2, 500);
        map.refresh(diagnosis, 1040, 0.1);
        assertTrue(map.toSurface(0.5, 0.5) > 10);
        map.refresh(diagnosis, 1060, 0.1);
        assertEquals(0, map.toSurface(0.5, 0.5));
    }

    @Test
    void whatWasSeenFreeIsKnownAndNoSurface() {
        RobotSpec robot = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        drive(robot, 0, 0, 1);
        diagnosis.markUnseen(1.1, 0);
        diagnosis.markUnseen(1.1, 0.5);
        drive(robot, 3, 3, 130);
        refresh();
        assertTrue(map.isKnown(1.1, 0), "the front sensor saw it free");
        assertTrue(map.toSurface(1.1, 0) > 0.1);
        assertFalse(map.isKnown(1.1, 0.5), "no sensor saw it");
        assertEquals(0, map.toSurface(1.1, 0.5));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2, 3, -1, -2.5})
    void theNearestSurfaceWithinTheAngleIsFound(double towards) {
        drive(BLIND, 2, 2, 50);
        double rx = diagnosis.reckoning().x();
        double ry = diagnosis.reckoning().y();
        assertTrue(Double.isNaN(bearing(towards, 0.5, 0.7)));
        mark(rx, ry, towards + 0.3, 0.5);
        mark(rx, ry, towards - 0.3, 0.6);
        mark(rx, ry, towards + 0.8, 0.3);
        assertEquals(0, Math.IEEEremainder(bearing(towards, 0.5, 0.7) - towards - 0.3, 2 * Math.PI), 0.04);
        assertEquals(0, Math.IEEEremainder(bearing(towards - 0.3, 0.4, 0.7) - towards + 0.3, 2 * Math.PI), 0.04);
        assertEquals(0, Math.IEEEremainder(bearing(towards, 1, 0.7) - towards - 0.8, 2 * Math.PI), 0.05);
        assertTrue(Double.isNaN(bearing(towards, 0.5, 0.45)));
    }

    private double bearing(double towards, double within, double limit) {
        refresh();
        return map.bearingOfSurface(towards, within, limit);
    }

    private void mark(double rx, double ry, double direction, double distance) {
        diagnosis.markUnseen(rx + distance * Math.cos(direction), ry + distance * Math.sin(direction));
    }
}
