package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Odometer;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Noise of 1 mm, at the wanted distance: the tracker needs 12 cm until its heading can be trusted. */
class BendDetectorTest {

    private static final double READING = 0.25;
    private static final double RADIUS = 0.35;
    private static final double STEP = 0.003;
    /** The number of readings whose mean has little enough noise. */
    private static final int AVERAGED = 10;

    private final StateEstimate estimate = new StateEstimate(WallFollowing.DEFAULT, new Odometer());
    private final WallTracker tracker = new WallTracker();
    private final BendDetector bends = new BendDetector(estimate, tracker);

    @BeforeEach
    void learnNoise() {
        for (int tick = 0; tick < 100; tick++) {
            double error = tick % 2 == 0 ? 0.56e-3 : -0.56e-3;
            estimate.update(Observations.observation(tick, Map.of("left", READING + error)));
        }
        assertEquals(1e-3, estimate.leftNoise(), 1e-5);
        tracker.start(READING);
    }

    private void roll(double metres) {
        tracker.predict(metres, 0, 0);
        tracker.predict(0, 0, 0);
    }

    /** Processes a reading that differs from its prediction. */
    private void read(double innovation) {
        tracker.predict(STEP, 0, 0);
        tracker.correctDistance(tracker.distance() + innovation, STEP, RADIUS);
    }

    @ParameterizedTest
    @CsvSource({"0.0079, false", "0.0081, true"})
    void oneReadingShowsABendIfItExceedsEightStandardDeviations(double innovation, boolean away) {
        read(innovation);
        assertEquals(away, bends.isAway());
    }

    @ParameterizedTest
    @CsvSource({"0.0039, false", "0.0041, true"})
    void twoReadingsShowABendIfBothExceedFour(double innovation, boolean away) {
        read(0.0078);
        read(innovation);
        assertEquals(away, bends.isAway());
    }

    @ParameterizedTest
    @CsvSource({"0.11, false", "0.12, true"})
    void behindABendOneReadingShowsAnotherOnceTheHeadingIsTrusted(double rolled, boolean away) {
        tracker.turnHeading(0);
        roll(rolled);
        read(0.04);
        assertEquals(away, bends.isAway());
    }

    @ParameterizedTest
    @CsvSource({"0.08, false", "0.11, true"})
    void theDriftShowsAWallOnceTheHeadingIsTrusted(double rolled, boolean back) {
        roll(rolled);
        for (int i = 0; i < 5; i++) {
            read(-0.03);
        }
        assertEquals(back, bends.isBack());
    }

    @Test
    void readingsBeforeABendDoNotCountBehindIt() {
        roll(0.2);
        for (int i = 0; i < WallTracker.MAX_INNOVATIONS; i++) {
            read(0.003);
        }
        assertTrue(bends.isAway());
        tracker.turnHeading(0);
        roll(0.2);
        for (int i = 1; i < AVERAGED; i++) {
            read(0.003);
            assertFalse(bends.isAway(), "after " + i);
        }
        read(0.003);
        assertTrue(bends.isAway());
    }

    @Test
    void theAngleIsThatOfTheReadingsBehindTheLastBend() {
        for (int i = 0; i < WallTracker.MAX_INNOVATIONS; i++) {
            read(0.0018);
        }
        assertEquals(Math.sqrt(2 * 0.0018 / RADIUS), bends.angle(), 2e-3);
        tracker.turnHeading(0);
        read(0.0025);
        assertEquals(Math.sqrt(2 * 0.0025 / RADIUS), bends.angle(), 2e-3);
    }
}
