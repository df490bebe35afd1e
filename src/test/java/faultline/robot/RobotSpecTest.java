package faultline.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The robot and its changed copies: each changes what its name says and nothing else. */
class RobotSpecTest {

    private static final DriveScale SCALE = new DriveScale(0.9, 1.1, 1.25);
    private static final RobotSpec ROBOT = new RobotSpec(
            0.4, 0.3, 0.2, 0.5, 2, new MotorSpec(0.1, 0.2, 5), SCALE, RobotSpec.standardSensors(0.4, 0.3));

    private static RobotSpec robot(double length, double width, double track, double speed, double turnRate) {
        return new RobotSpec(length, width, track, speed, turnRate, ROBOT.motor(), SCALE, ROBOT.sensors());
    }

    @ParameterizedTest
    @CsvSource({
        "0, 1, 1, 1, 1",
        "1, 0, 1, 1, 1",
        "1, 1, 0, 1, 1",
        "1, 1, 1, 0, 1",
        "1, 1, 1, 1, 0",
        "Infinity, 1, 1, 1, 1"
    })
    void whatIsNotPositiveAndFiniteIsRefused(double length, double width, double track, double speed, double turnRate) {
        assertThrows(IllegalArgumentException.class, () -> robot(length, width, track, speed, turnRate));
    }

    @Test
    void twoSensorsWithOneIdAreRefused() {
        List<SensorSpec> twice = List.of(ROBOT.sensors().get(0), ROBOT.sensors().get(0));
        assertThrows(IllegalArgumentException.class, () -> ROBOT.withSensors(twice));
    }

    @ParameterizedTest
    @CsvSource({
        "front, 0.2, 0, 0",
        "front-left, 0.2, 0.15, 45",
        "left, 0, 0.15, 90",
        "rear-left, -0.2, 0.15, 135",
        "rear, -0.2, 0, 180",
        "rear-right, -0.2, -0.15, -135",
        "right, 0, -0.15, -90",
        "front-right, 0.2, -0.15, -45"
    })
    void theStandardSensorsLookOutwardsFromTheEdges(String id, double x, double y, double bearing) {
        SensorSpec sensor = ROBOT.withSensors(RobotSpec.standardSensors(0.4, 0.3))
                .sensor(id)
                .orElseThrow();
        assertEquals(new Vector2(x, y), sensor.mountPosition());
        assertEquals(Math.toRadians(bearing), sensor.bearing(), 1e-15);
    }

    @Test
    void sensorsAreFoundById() {
        assertEquals(2, ROBOT.indexOf("left"));
        assertEquals(-1, ROBOT.indexOf("nose"));
        assertEquals(Optional.empty(), ROBOT.sensor("nose"));
        SensorSpec longer = ROBOT.sensor("left").orElseThrow().withRange(1.5);
        RobotSpec changed = ROBOT.withSensor(longer);
        assertEquals(1.5, changed.sensors().get(2).range());
        assertEquals(ROBOT.sensors().get(3), changed.sensors().get(3));
        SensorSpec unknown = new SensorSpec("nose", Vector2.ZERO, 0, 1, 1, true, 0);
        assertThrows(IllegalArgumentException.class, () -> ROBOT.withSensor(unknown));
    }

    @Test
    void aChangedCopyKeepsTheRest() {
        assertEquals(robot(1, 2, 0.2, 3, 2), ROBOT.withPlatform(1, 2, 3));
        assertEquals(robot(0.4, 0.3, 0.2, 0.7, 2), ROBOT.withSpeed(0.7));
        assertEquals(robot(0.4, 0.3, 0.2, 0.5, 3), ROBOT.withTurnRate(3));
        assertEquals(MotorSpec.DEFAULT, ROBOT.withMotor(MotorSpec.DEFAULT).motor());
        assertEquals(ROBOT, ROBOT.withMotor(MotorSpec.DEFAULT).withMotor(ROBOT.motor()));
    }

    @Test
    void theControllerBelievesInADriveWithoutError() {
        assertEquals(DriveScale.NONE, ROBOT.believed().driveScale());
        assertEquals(ROBOT, ROBOT.believed().withDriveScale(SCALE));
        assertSame(RobotSpec.DEFAULT, RobotSpec.DEFAULT.believed());
        assertEquals(0.25, ROBOT.trueTrack(), 1e-15);
        assertEquals(0.25, ROBOT.boundingRadius(), 1e-15);
    }

    @Test
    void theLimitsOfAScaleAreAllowedAndNothingBeyond() {
        assertEquals(0.1, new DriveScale(0.1, 10, 1).left());
        assertThrows(IllegalArgumentException.class, () -> new DriveScale(Math.nextDown(0.1), 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new DriveScale(1, 1, Math.nextUp(10)));
    }

    @Test
    void theFaultsOfASideActInTheirOrderAndOnNoOtherSide() {
        List<MotorFault> faults = List.of(new MotorFault.DeadBand(1), new MotorFault.Weak(0.5));
        MotorFaults left = MotorFaults.NONE.with(MotorSide.LEFT, faults);
        assertEquals(1.5, left.apply(MotorSide.LEFT, 4));
        assertEquals(4, left.apply(MotorSide.RIGHT, 4));
        MotorFaults right = MotorFaults.NONE.with(MotorSide.RIGHT, faults);
        assertEquals(faults, right.of(MotorSide.RIGHT));
        assertEquals(4, right.apply(MotorSide.LEFT, 4));
        assertEquals(1.5, right.with(MotorSide.LEFT, List.of()).apply(MotorSide.RIGHT, 4));
    }

    @Test
    void kindsHaveTheNamesAndNumbersOfTheFormat() {
        assertEquals("dead-band", MotorFaultKind.DEAD_BAND.fileName());
        assertEquals(0.7, MotorFaultKind.WEAK.defaultValue());
        assertEquals(1, MotorFaultKind.WEAK.createFault(1).value());
        assertEquals(0, MotorFaultKind.WEAK.createFault(0).value());
        assertEquals("V", MotorFaultKind.DEAD_BAND.unit());
        assertEquals(10_000, MotorFaultKind.DEAD_BAND.maxValue());
        assertEquals(MotorFaultKind.DEAD, MotorFaultKind.DEAD.createFault(7).kind());
    }

    /**
     * Wheels that are 0.18 m apart, as by default, and roll at 0.9 m/s in opposite directions turn the robot by 10
     * rad/s.
     */
    @Test
    void theMotorsLimitTheTurnOnTheSpot() {
        RobotSpec robot = RobotSpec.DEFAULT.withMotor(new MotorSpec(0.1, 0.18, 5));
        assertEquals(10, robot.maxTurnRate(), 1e-12);
        assertEquals(3, robot.withTurnRate(3).spinRate());
        assertEquals(10, robot.withTurnRate(12).spinRate(), 1e-12);
    }

    @Test
    void aScaledMotorTurnsItsWheelsFasterAtTheSameVoltage() {
        MotorSpec motor = new MotorSpec(0.1, 0.2, 5);
        assertSame(motor, motor.scaled(1));
        assertEquals(new MotorSpec(0.1, 0.4, 5), motor.scaled(2));
        assertEquals(1, motor.maxSpeed(), 1e-15);
        assertEquals(2.5, motor.voltageFor(0.5), 1e-15);
        assertEquals(0, new MotorSpec(0, 0.2, 5).decay(0.1));
    }
}
