package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.SensorFinding;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The front sensor sees nothing, although a surface is very near to one that looks ahead to the right. */
class MissedSurfacesTest {

    private static final int FRONT = 0;
    private static final int WITNESS = 1;
    private static final int OTHER = 2;
    private static final int NOW = 5;
    private static final double BEARING = Math.toRadians(-45);
    private static final double NEAR = 0.1;
    private static final double WANTED = 0.25;
    /** The share of the threshold that one missed surface counts. */
    private static final double MISSED = 5.0 / 7;

    private final InspectedSensor[] sensors = new InspectedSensor[3];
    private final double[] readings = {Reading.NOTHING, NEAR, Reading.NOTHING};
    private final TrustAssessment assessment = new TrustAssessment(sensors.length);
    private final EvidenceGrid grid = new EvidenceGrid(sensors.length + 1);
    private final DeadReckoning reckoning = new DeadReckoning();

    private void mount(double frontX, double frontRange) {
        sensors[FRONT] = sensor(FRONT, frontX, 0, frontRange);
        sensors[WITNESS] = sensor(WITNESS, 0, BEARING, 0.8);
        sensors[OTHER] = sensor(OTHER, 0, Math.PI / 2, 0.8);
        for (int i = 0; i < 3; i++) {
            sensors[WITNESS].measurements().add(0, 0, BEARING, Math.cos(BEARING), Math.sin(BEARING), NEAR, 0);
        }
    }

    private static InspectedSensor sensor(int index, double x, double bearing, double range) {
        return new InspectedSensor(index, new MountedCone(x, 0, bearing, Math.toRadians(10), range));
    }

    /** Drives at a speed in metres per second and returns the evidence that the front sensor has missed a surface. */
    private double evidenceAt(double speed) {
        RobotSpec prompt = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
        reckoning.advance(prompt, 10 * speed, 10 * speed, 1e-6, 1);
        new MissedSurfaces(sensors, assessment, grid, reckoning).test(sensors[WITNESS], readings, WANTED, NOW, 1);
        return assessment.evidence(FRONT);
    }

    @Test
    void aSurfaceThatOnlyTheOtherSensorSeesIsMissed() {
        mount(0, 0.8);
        assertEquals(MISSED, evidenceAt(0.3));
    }

    @ParameterizedTest
    @CsvSource({"0.059, 0", "0.061, 1", "-0.3, 0"})
    void aSurfaceIsExpectedAheadOfARobotThatDrivesForwards(double speed, int missed) {
        mount(0, 0.8);
        assertEquals(missed * MISSED, evidenceAt(speed));
    }

    @ParameterizedTest
    @CsvSource({"0.79, 0", "0.8, 1", "0.81, 1"})
    void aFrontSensorThatSeesSomethingMissesNothing(double reading, int missed) {
        mount(0, 0.8);
        readings[FRONT] = reading;
        assertEquals(missed * MISSED, evidenceAt(0.3));
    }

    @Test
    void aFrontSensorThatIsNotTrustedIsNotCounted() {
        mount(0, 0.8);
        assessment.distrust(FRONT, SensorFinding.STUCK, 0);
        assertEquals(0, evidenceAt(0.3));
    }

    @ParameterizedTest
    @CsvSource({"1, true", "5, false"})
    void aSensorThatTwoOthersContradictIsNoWitness(int others, boolean missed) {
        mount(0, 0.8);
        assessment.addContradiction(WITNESS, others, 1);
        assessment.distrust(WITNESS, SensorFinding.CONTRADICTED, 0);
        assertEquals(missed, evidenceAt(0.3) >= MISSED);
    }

    @ParameterizedTest
    @CsvSource({"0, 0.29, 0", "0, 0.295, 1", "0.1, 0.19, 0", "0.1, 0.195, 1", "-0.1, 0.39, 0", "-0.1, 0.395, 1"})
    void theFrontSensorMustReachWhereTheSurfaceCanBe(double frontX, double range, int missed) {
        // The surface is 0.141 m ahead of the sensor that sees it, or up to 0.15 m farther.
        mount(frontX, range);
        assertEquals(missed * MISSED, evidenceAt(0.3));
    }

    @ParameterizedTest
    @ValueSource(ints = {WITNESS, OTHER, 3})
    void aPlaceThatAnotherSensorOrTheBodyFoundFreeIsNoSurface(int source) {
        mount(0, 0.8);
        grid.markDisc(source, 0.2, 0, 0.2, NOW);
        assertEquals(0, evidenceAt(0.3));
    }

    @Test
    void theFrontSensorItselfDoesNotRefuteIt() {
        mount(0, 0.8);
        grid.markDisc(FRONT, 0.2, 0, 0.2, NOW);
        assertEquals(MISSED, evidenceAt(0.3));
    }

    @Test
    void aPlaceThatWasFreeTooLongAgoMayHaveASurface() {
        mount(0, 0.8);
        grid.markDisc(OTHER, 0.2, 0, 0.2, NOW - 1);
        assertEquals(MISSED, evidenceAt(0.3));
    }
}
