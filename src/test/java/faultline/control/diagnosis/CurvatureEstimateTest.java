package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.sensor.Reading;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CurvatureEstimateTest {

    private static final double STEP = 0.003;

    private final CurvatureEstimate estimate = new CurvatureEstimate();
    private double y = -0.27;
    private double heading;

    /** Drives along a wall at y = 0 and steers by its distance; the path bends by more than is believed. */
    private void drive(double way, double trueBend, double noise) {
        SplittableRandom random = new SplittableRandom(11);
        for (double done = 0; done < way; done += STEP) {
            double reading = -y + noise * (2 * random.nextDouble() - 1);
            double believedTurn = STEP * (12 * (-y - 0.25) - 7 * heading);
            y += STEP * Math.sin(heading);
            heading += believedTurn + trueBend * STEP;
            estimate.update(reading, 0.002, STEP, believedTurn);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.45, -0.2, 0.17, 0.5})
    void aBendThatIsNotBelievedIsLearntFromAStraightWall(double bend) {
        drive(4, bend, 0.004);
        assertEquals(bend, estimate.curvature(), 0.06);
    }

    @Test
    void nothingIsCorrectedWhereBeliefAndTruthAgree() {
        drive(4, 0, 0.004);
        assertEquals(0, estimate.curvature());
        drive(4, 0.05, 0);
        assertEquals(0, estimate.curvature());
    }

    @Test
    void cornersAndGapsDoNotSpoilIt() {
        for (int i = 0; i < 12; i++) {
            drive(1.2, 0.3, 0);
            estimate.update(Reading.NOTHING, Double.NaN, STEP, 0);
            y = -0.25;
            heading = 0;
            for (int j = 0; j < 120; j++) {
                estimate.update(0.25, 0.002, STEP, 3 * STEP);
            }
        }
        assertEquals(0.3, estimate.curvature(), 0.06);
    }

    @Test
    void aRoundWallTeachesNothing() {
        for (int i = 0; i < 2000; i++) {
            estimate.update(0.25, 0.04, STEP, -0.7 * STEP);
        }
        assertEquals(0, estimate.curvature());
    }

    @Test
    void samplesThatDisagreeTeachNothing() {
        for (int i = 0; i < 12; i++) {
            drive(0.45, i % 2 == 0 ? 0.6 : -0.1, 0);
            assertEquals(0, estimate.curvature(), "after leg " + i);
        }
    }

    /** Drives while the robot turns as believed and the reading bends by itself. */
    private void drive(double way, double turning, double readingCurvature, double sag) {
        int steps = (int) Math.round(way / STEP);
        for (int i = 0; i < steps; i++) {
            double s = i * STEP;
            estimate.update(0.25 + readingCurvature * s * s / 2, sag, STEP, turning * STEP);
        }
    }

    @ParameterizedTest
    @CsvSource({
        // Three legs of 0.15 m turn the robot by 18 and by 22 degrees.
        "0.7, -0.2, 0.002, -0.5",
        "0.86, -0.36, 0.002, 0",
        "-0.7, 0.2, 0.002, 0.5",
        "-0.86, 0.36, 0.002, 0",
        "0, 0.5, 0.014, -0.5",
        "0, 0.5, 0.016, 0",
        "0, 0.5, -0.014, -0.5",
        "0, 0.5, -0.016, 0",
        "0, 0.78, 0, -0.78",
        "0, 0.82, 0, 0",
        "0, 0.11, 0, -0.11",
        "0, 0.09, 0, 0"
    })
    void onlyStraightWallsAndGentlePathsTeach(double turning, double curvature, double sag, double expected) {
        drive(2, turning, curvature, sag);
        assertEquals(expected, estimate.curvature(), 0.012);
    }

    @Test
    void sevenSamplesAreNeededAndLaterOnesReplaceThem() {
        drive(1.3, 0, 0.5, 0);
        assertEquals(0, estimate.curvature(), "six samples");
        drive(0.06, 0, 0.5, 0);
        estimate.update(0, Double.NaN, STEP, 0);
        drive(2.5, 0, 0.5, 0);
        assertEquals(-0.5, estimate.curvature(), 0.02);
        estimate.update(0, Double.NaN, STEP, 0);
        drive(2.5, 0, -0.3, 0);
        assertEquals(0.3, estimate.curvature(), 0.02);
    }

    @Test
    void aWallThatIsLostBeginsNewLegs() {
        for (int i = 0; i < 60; i++) {
            drive(0.44, 0, 0.5, 0);
            estimate.update(0, Double.NaN, STEP, 0);
            assertEquals(0, estimate.curvature(), "two legs and a part of the third");
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0.5", "1, 0.5", "2, 0"})
    void oneSampleOfSevenMayDisagree(int wrong, double expected) {
        for (int i = 0; i < 7; i++) {
            drive(0.46, 0, i < wrong ? 0.2 : -0.5, 0);
            estimate.update(0, Double.NaN, STEP, 0);
        }
        assertEquals(expected, estimate.curvature(), 0.02);
    }

    @Test
    void legsOfLongStepsAreLonger() {
        double step = 0.04;
        for (int i = 0; i < 100; i++) {
            double s = i * step;
            estimate.update(0.25 - 0.5 * s * s / 2, 0, step, 0);
        }
        assertEquals(0.5, estimate.curvature(), 1e-3);
    }
}
