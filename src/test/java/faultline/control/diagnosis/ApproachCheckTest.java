package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Reading;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A sensor that looks ahead to the right measures while the robot drives straight on. */
class ApproachCheckTest {

    private static final double HALF = Math.toRadians(10);
    private static final double STEP = 0.03;
    private static final int MEASUREMENTS = 7;
    private static final MountedCone CONE = new MountedCone(0.12, -0.08, Math.toRadians(-45), HALF, 0.8);

    private final InspectedSensor sensor = new InspectedSensor(0, CONE);

    /** Adds measurements of which each is a step of the path after the one before, in a frame that is turned. */
    private void drive(double heading, double step, DoubleUnaryOperator readingAfter) {
        for (int i = 0; i < MEASUREMENTS; i++) {
            addMeasurement(heading, i * step, heading + CONE.bearing(), readingAfter.applyAsDouble(i * step));
        }
    }

    private void addMeasurement(double heading, double driven, double axis, double reading) {
        double x = 5 + driven * Math.cos(heading);
        double y = -2 + driven * Math.sin(heading);
        sensor.measurements().add(x, y, axis, Math.cos(axis), Math.sin(axis), reading, 0);
    }

    /**
     * Returns the distance to the nearest point in the cone of a wall that crosses the path ahead of the sensor, by
     * looking along many rays. The foot of the wall is to the right if its slant is positive.
     */
    private static double readingOfWall(double ahead, double slant) {
        double foot = ahead * Math.cos(slant) - CONE.y() * -Math.sin(slant);
        double least = Reading.NOTHING;
        for (double off = -HALF; off <= HALF; off += HALF / 1000) {
            double towards = Math.cos(CONE.bearing() + off + slant);
            least = towards > 0 ? Math.min(least, foot / towards) : least;
        }
        return least;
    }

    private double expectedOfWall(double heading, double step, double ahead, double slant) {
        drive(heading, step, driven -> readingOfWall(ahead + (MEASUREMENTS - 1) * step - driven, slant));
        return ApproachCheck.expectedAhead(sensor);
    }

    @ParameterizedTest
    @CsvSource({
        "-20, 0.17, 0",
        "-10, 0.22, 1",
        "0, 0.29, 0",
        "0, 0.25, 2.5",
        "10, 0.29, -2",
        "20, 0.35, 0",
        "21, 0.3, 4"
    })
    void aWallCrossesThePathAtItsSlant(double degrees, double ahead, double heading) {
        assertEquals(ahead, expectedOfWall(heading, STEP, ahead, Math.toRadians(degrees)), 1e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {22, 25, 40})
    void aMoreSlantedWallMayEndBesideThePath(double degrees) {
        assertEquals(Reading.NOTHING, expectedOfWall(0, STEP, 0.29, Math.toRadians(degrees)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.25})
    void anObjectBesideThePathIsNotAhead(double aside) {
        double ahead = aside / Math.tan(Math.toRadians(36));
        drive(0, 0.02, driven -> Math.hypot(ahead - driven, aside));
        assertEquals(Reading.NOTHING, ApproachCheck.expectedAhead(sensor));
    }

    @ParameterizedTest
    @CsvSource({"0.29, true", "0.31, false"})
    void aSurfaceFarFromThePathMayEndBeforeIt(double ahead, boolean crosses) {
        // It is 0.29 m from the path if the reading is 0.366 m.
        double expected = expectedOfWall(0, STEP, ahead, 0);
        assertEquals(crosses ? ahead : Reading.NOTHING, expected, 1e-3);
    }

    @ParameterizedTest
    @CsvSource({"0.0130, false", "0.0134, true"})
    void theRateIsThatOverEightCentimetresAtLeast(double step, boolean crosses) {
        double expected = expectedOfWall(0, step, 0.25, 0);
        assertEquals(crosses ? 0.25 : Reading.NOTHING, expected, 1e-3);
    }

    @ParameterizedTest
    @CsvSource({"2.9, true", "3.1, false", "-3.1, false"})
    void theRateIsThatOfAStraightPath(double degrees, boolean crosses) {
        double axis = CONE.bearing() + Math.toRadians(degrees);
        addMeasurement(0, 0, axis, readingOfWall(0.25 + 4 * 0.04, 0));
        for (int i = 1; i <= 4; i++) {
            addMeasurement(0, 0.04 * i, CONE.bearing(), readingOfWall(0.25 + (4 - i) * 0.04, 0));
        }
        assertEquals(crosses, ApproachCheck.expectedAhead(sensor) < Reading.NOTHING);
    }

    @Test
    void aMeasurementThatSawNothingGivesNoRate() {
        drive(0, STEP, driven -> driven == 3 * STEP ? -1 : readingOfWall(0.25 + 6 * STEP - driven, 0));
        assertEquals(Reading.NOTHING, ApproachCheck.expectedAhead(sensor));
    }

    @ParameterizedTest
    @CsvSource({"-45, true", "45, false", "0, false", "-90, false"})
    void itAppliesOnTheSideAwayFromTheWall(double degrees, boolean applies) {
        MountedCone cone = new MountedCone(0.12, 0, Math.toRadians(degrees), HALF, 0.8);
        assertEquals(applies, ApproachCheck.applies(cone));
    }
}
