package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The curvature of the path is sampled at equal distances. */
class PathCurvatureTest {

    private static final double DT = 0.01;
    private static final double VOLTS = 3;

    private final RobotSpec robot = RobotSpec.DEFAULT;
    private final MotionAccumulator motion = new MotionAccumulator();
    private final DeadReckoning reckoning = new DeadReckoning();
    private final InspectedSensor[] sensors = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(i, MountedCone.of(robot.sensors().get(i), 1)))
            .toArray(InspectedSensor[]::new);
    private final WallLine line = new WallLine(sensors);
    private final PathCurvature check = new PathCurvature(motion, reckoning);

    @BeforeEach
    void refit() {
        check.refit(line);
    }

    /** Returns what the sensors read beside a wall at a distance from the robot's centre line. */
    private double[] beside(double distance) {
        double[] readings = new double[sensors.length];
        Arrays.fill(readings, Reading.NOTHING);
        double[] ones = new double[sensors.length];
        Arrays.fill(ones, 1);
        for (int place = 0; place < 3; place++) {
            double least = line.aside(place, new double[sensors.length]);
            readings[line.sensor(place).index()] = (distance - least) / (line.aside(place, ones) - least);
        }
        return readings;
    }

    /** Drives straight on by the motor model on a path that bends, and returns the number of samples. */
    private int drive(double metres, double bend) {
        int count = 0;
        double start = motion.netDistance();
        while (motion.netDistance() < start + metres) {
            reckoning.advance(robot, VOLTS, VOLTS, DT, 1);
            motion.advance(reckoning.rolled(), reckoning.turned(), DT);
            if (check.isDue(motion)) {
                double driven = motion.netDistance() - start;
                check.run(beside(0.4 - bend * driven * driven / 2), 1);
                count++;
            }
        }
        return count;
    }

    @Test
    void oneSampleIsTakenForEachCentimetre() {
        drive(1, 0);
        double step = reckoning.rolled();
        int count = drive(3, 0);
        assertTrue(count <= 3 / 0.01 + 1 && count >= 3 / (0.01 + step) - 1, count + " in 3 m");
    }

    @Test
    void aRobotThatTurnsOnTheSpotIsNotSampled() {
        assertFalse(check.isDue(motion), "at the start");
        drive(0.1, 0);
        check.run(beside(0.4), 1);
        motion.advance(0, 0.5, DT);
        assertFalse(check.isDue(motion));
    }

    /** The path bends towards the wall, so that the reading is a parabola. */
    @Test
    void aBentPathCorrectsTheDeadReckoning() {
        drive(1.7, 0.15);
        double before = reckoning.heading();
        drive(0.2, 0);
        assertEquals(0.15, (reckoning.heading() - before) / 0.2, 0.05);
    }

    @Test
    void aStraightPathCorrectsNothing() {
        drive(3, 0);
        assertEquals(0, reckoning.heading());
    }
}
