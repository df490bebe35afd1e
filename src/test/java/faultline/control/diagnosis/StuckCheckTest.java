package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StuckCheckTest {

    private static final double STEP = 0.001;

    /** A surface straight in front of a sensor that looks 40 degrees aside comes nearer by 77 percent of the way. */
    @ParameterizedTest
    @CsvSource({"0, 0.045, false", "0, 0.055, true", "40, 0.06, false", "40, 0.07, true", "-40, 0.07, true"})
    void theWayAlongTheAxisCounts(double degrees, double metres, boolean stuck) {
        MotionAccumulator motion = new MotionAccumulator();
        MountedCone cone = new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(45), 0.8);
        StuckCheck check = new StuckCheck(cone, motion);
        boolean found = false;
        for (double driven = 0; driven < metres - STEP / 2; driven += STEP) {
            motion.advance(STEP, 0, 0.01);
            found = check.test(0.1, 0.1);
        }
        assertEquals(stuck, found);
    }
}
