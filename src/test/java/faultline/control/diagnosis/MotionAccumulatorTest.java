package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class MotionAccumulatorTest {

    @Test
    void stepsAreAddedWithTheirSigns() {
        MotionAccumulator motion = new MotionAccumulator();
        motion.advance(0.5, -0.25, 0.5);
        motion.advance(-0.125, -0.5, 0.25);
        assertEquals(-0.125, motion.rolled());
        assertEquals(-0.5, motion.turned());
        assertEquals(0.375, motion.netDistance());
        assertEquals(-0.75, motion.heading());
        assertEquals(0.75, motion.time());
        assertEquals(-2, motion.turnRate());
        assertEquals(0.25, motion.unsteadiness());
        assertEquals(2, motion.steps());
    }

    @Test
    void theClockRunsWithDistanceAngleAndTime() {
        MotionClock clock = new MotionClock();
        assertEquals(1_000_000, clock.moment());
        clock.advance(0.01, 0, 0);
        assertEquals(1_000_010, clock.moment());
        clock.advance(-0.01, 0, 0);
        assertEquals(1_000_020, clock.moment());
        clock.advance(0, 0.1, 0);
        clock.advance(0, -0.1, 0);
        assertEquals(1_000_040, clock.moment());
        clock.advance(0, 0, 0.5);
        assertEquals(1_000_045, clock.moment());
        clock.advance(0.0005, 0, 0);
        assertEquals(1_000_045.5, clock.ticks(), 1e-9);
        assertEquals(1_000_045, clock.moment());
    }
}
