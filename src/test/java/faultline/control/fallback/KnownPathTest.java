package faultline.control.fallback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class KnownPathTest {

    private static final RobotSpec PROMPT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
    private static final RobotSpec BLIND = PROMPT.withSensors(List.of());

    private final SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
    private final LocalMap map = new LocalMap();
    private final KnownPath path = new KnownPath(diagnosis, new FreeDirectionFinder(map));
    private long tick;

    /** Lets a robot drive in the open, where it sees nothing, and leaves a known disc around it. */
    private void drive(RobotSpec robot, double left, double right, int ticks, double knownRadius) {
        double[] readings = new double[robot.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        for (int i = 0; i < ticks; i++) {
            diagnosis.update(new Observation(tick++, 0.01, robot, readings), left, right, 1);
        }
        map.refresh(diagnosis, 1000, knownRadius);
    }

    @Test
    void anUnknownPathNeedsAScanAndAKnownOneEndsIt() {
        drive(BLIND, 0, 0, 1, 0.5);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        assertFalse(path.isScanning());
        drive(BLIND, 0, 0, 1, 0.15);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        assertTrue(path.isScanning());
        // The ground is known for 0.13 m ahead of the front: enough to drive, but not to end a scan.
        drive(BLIND, 0, 0, 1, 0.28);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        assertTrue(path.isScanning());
        drive(BLIND, 0, 0, 1, 0.5);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        assertFalse(path.isScanning());
    }

    @Test
    void aNewStartEndsAScan() {
        drive(BLIND, 0, 0, 1, 0.15);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        path.endScan();
        assertFalse(path.isScanning());
    }

    @Test
    void whatNoSensorCanSeeCountsAsASurface() {
        drive(BLIND, 0, 0, 1, 0.15);
        assertTrue(map.toSurface(0.3, 0) > 1);
        path.update(BLIND, 0, DriveDirection.FORWARDS);
        path.advanceScan(BLIND, 0, DriveDirection.FORWARDS);
        assertFalse(path.isScanning());
        drive(BLIND, 0, 0, 1, 0.15);
        assertTrue(map.toSurface(0.15, 0) < 0.1, "at the front of the robot: " + map.toSurface(0.15, 0));
    }

    /** Only the sensor with the given index is mounted; all directions are those of a robot that looks along x. */
    @ParameterizedTest
    @CsvSource({"2, 0, -1", "6, 0, 1", "2, 150, 1", "6, -150, -1"})
    void theRobotTurnsUntilItsSensorSeesThePath(int sensor, double direction, double sign) {
        RobotSpec robot = PROMPT.withSensors(List.of(PROMPT.sensors().get(sensor)));
        drive(robot, 0, 0, 1, 0.15);
        path.update(robot, Math.toRadians(direction), DriveDirection.FORWARDS);
        assertTrue(path.isScanning());
        assertEquals(sign, path.scanSign());
    }

    @Test
    void theGroundFromWhichTheRobotHasComeIsFree() {
        RobotSpec robot = PROMPT.withSensors(List.of(PROMPT.sensors().get(0)));
        drive(robot, 0, 0, 1, 0.1);
        assertFalse(path.isBehindFree(robot));
        drive(robot, 3, 3, 100, 0.1);
        assertTrue(path.isBehindFree(robot));
    }
}
