package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a marker adds to the grid, and what it counts as a confirmation. The sensors are at the origin. */
class AddedEvidenceTest {

    private static final int SENSORS = 3;
    private static final double READING = 0.4;
    /** More inspections than a disagreement of two sensors may last. */
    private static final int ENOUGH = 30;

    private final EvidenceGrid grid = new EvidenceGrid(SENSORS + 1);
    private final TrustAssessment assessment = new TrustAssessment(SENSORS);
    private final MotionClock clock = new MotionClock();
    private final EvidenceMarker marker =
            new EvidenceMarker(SENSORS, grid, new ArcCheck(grid, SENSORS), assessment, new DeadReckoning(), clock);

    @BeforeEach
    void begin() {
        marker.begin(false, 1);
    }

    private static InspectedSensor sensor(int index, double degrees) {
        MountedCone cone = new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(10), 0.8);
        return new InspectedSensor(index, cone);
    }

    /** Adds a new measurement of a sensor; one of the range sees nothing. */
    private void measure(InspectedSensor sensor, double reading) {
        remember(sensor, reading);
        marker.add(sensor, reading < sensor.cone().range(), reading);
    }

    private void remember(InspectedSensor sensor, double reading) {
        double axis = sensor.cone().bearing();
        sensor.measurements().add(0, 0, axis, Math.cos(axis), Math.sin(axis), reading, clock.ticks());
    }

    private boolean isFree(int source, double x, double y) {
        int column = EvidenceGrid.cellOf(x);
        int row = EvidenceGrid.cellOf(y);
        return grid.freeBy(column, row, clock.moment(), 1 << source) != 0;
    }

    /** Returns which of the first two sensors is distrusted if they contradict only each other. */
    private int lessCredible() {
        assessment.addContradiction(0, 0b10, 6);
        for (int i = 0; i < ENOUGH && assessment.allTrusted(); i++) {
            assessment.assess(0, 0);
            assessment.assess(1, 0);
        }
        return Integer.numberOfTrailingZeros(~assessment.trusted());
    }

    @ParameterizedTest
    @CsvSource({"1, 0, 1", "1, 1, 0", "1, 2, 0", "8, 7, 1", "8, 8, 0", "8, 9, 0"})
    void aMeasurementConfirmedByAnotherSensorCountsByItsWeight(int weight, int ofTheOther, int distrusted) {
        marker.begin(false, weight);
        measure(sensor(2, 0), READING);
        measure(sensor(0, 0), READING);
        assessment.addConfirmation(1, ofTheOther);
        assertEquals(distrusted, lessCredible());
    }

    @ParameterizedTest
    @CsvSource({"2, 1", "3, 0", "4, 0"})
    void itCountsForThoseThatWereNotAdded(int ofTheOther, int distrusted) {
        measure(sensor(2, 0), READING);
        InspectedSensor confirmed = sensor(0, 0);
        remember(confirmed, READING);
        remember(confirmed, READING);
        measure(confirmed, READING);
        assessment.addConfirmation(1, ofTheOther);
        assertEquals(distrusted, lessCredible());
    }

    @Test
    void aSensorDoesNotConfirmItself() {
        marker.begin(true, 1);
        InspectedSensor alone = sensor(0, 0);
        for (int i = 0; i < ENOUGH; i++) {
            measure(alone, READING);
        }
        assessment.addConfirmation(1, 1);
        assertEquals(0, lessCredible());
    }

    @ParameterizedTest
    @CsvSource({"0, false, true", "90, false, true", "-90, false, false", "-90, true, true", "180, false, false"})
    void sensorsThatLookAwayMarkFarPlacesOnlyIfSomethingIsSuspicious(double degrees, boolean suspicious, boolean far) {
        marker.begin(suspicious, 1);
        InspectedSensor sensor = sensor(1, degrees);
        measure(sensor, 0.8);
        double cos = Math.cos(sensor.cone().bearing());
        double sin = Math.sin(sensor.cone().bearing());
        // Two rows, of which one may be left to the next measurement.
        assertEquals(far, isFree(1, 0.69 * cos, 0.69 * sin) || isFree(1, 0.715 * cos, 0.715 * sin));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.3})
    void allRowsOfANearSectorAreMarked(double free) {
        measure(sensor(1, 90), free);
        for (double y = 0.1; y < free - 0.06; y += EvidenceGrid.CELL) {
            assertTrue(isFree(1, 0.001, y), "at " + y);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theBodyThatRestsIsAddedAgainOnlyIfSomethingIsSuspicious(boolean suspicious) {
        marker.addBody(0.1);
        assertTrue(isFree(SENSORS, 0, 0));
        clock.advance(0, 0, 1);
        marker.begin(suspicious, 1);
        marker.addBody(0.1);
        assertEquals(suspicious, isFree(SENSORS, 0, 0));
    }
}
