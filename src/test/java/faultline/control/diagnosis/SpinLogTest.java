package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.WallSide;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class SpinLogTest {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));
    private static final double DT = 0.01;
    private static final int LEFT = 2;

    private final DeadReckoning reckoning = new DeadReckoning();
    private final InspectedSensor left =
            new InspectedSensor(LEFT, MountedCone.of(ROBOT.sensors().get(LEFT), WallSide.LEFT));
    private final SpinLog log = new SpinLog(8);

    @BeforeEach
    void clear() {
        log.clear();
    }

    /** Drives for a tick, and adds what all sensors read. */
    private void add(double leftVolts, double rightVolts, double reading) {
        reckoning.advance(ROBOT, leftVolts, rightVolts, DT, 1);
        double[] readings = new double[8];
        Arrays.fill(readings, reading);
        log.add(reckoning, readings);
    }

    @Test
    void distancesAreFromThePositionOfTheFirstEntry() {
        add(-3, 3, 0.5);
        double x = reckoning.x();
        double y = reckoning.y();
        assertEquals(0.5, log.distance(0, left));
        for (int i = 0; i < 100; i++) {
            add(2, 3, 0.4);
        }
        double direction = log.direction(100, left.cone());
        assertEquals(reckoning.heading() + left.cone().bearing(), direction);
        double expected = 0.4 + (reckoning.x() - x) * Math.cos(direction) + (reckoning.y() - y) * Math.sin(direction);
        assertEquals(expected, log.distance(100, left), 1e-12);
        assertTrue(Math.abs(expected - 0.4) > 0.05, "the robot has moved along the axis");
    }

    @Test
    void nothingSeenAndASensorThatIsOffHaveNoDistance() {
        add(-3, 3, Reading.NOTHING);
        add(-3, 3, Reading.OFF);
        add(-3, 3, left.cone().range());
        for (int i = 0; i < 3; i++) {
            assertTrue(Double.isNaN(log.distance(i, left)), "entry " + i);
        }
    }

    @Test
    void theOldestEntriesAreDropped() {
        double[] headings = new double[500];
        for (int i = 0; i < headings.length; i++) {
            add(-3, 3, 0.5);
            headings[i] = reckoning.heading();
        }
        assertEquals(2 * SpinProfile.DIRECTIONS, log.size());
        for (int i = 0; i < log.size(); i++) {
            double heading = headings[headings.length - log.size() + i];
            assertEquals(heading + left.cone().bearing(), log.direction(i, left.cone()), "entry " + i);
        }
    }

    @Test
    void theTurnIsBetweenTheOutermostHeadings() {
        for (int i = 0; i < 30; i++) {
            add(-3, 3, 0.5);
        }
        double most = reckoning.heading();
        for (int i = 0; i < 60; i++) {
            add(3, -3, 0.5);
        }
        assertEquals(most - reckoning.heading(), log.turn(), 1e-12);
        log.clear();
        add(-3, 3, 0.5);
        assertEquals(0, log.turn());
        assertEquals(1, log.size());
    }
}
