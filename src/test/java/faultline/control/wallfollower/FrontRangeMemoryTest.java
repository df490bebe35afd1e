package faultline.control.wallfollower;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.geometry.Vector2;
import faultline.sensor.Reading;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class FrontRangeMemoryTest {

    private static final double HALF_WIDTH = 0.1;
    private static final double QUARTER_TURN = Math.PI / 2;

    private final FrontRangeMemory memory = new FrontRangeMemory();

    /** A cone of 20 degrees: at 0.3 m its edge is 52 mm aside, in the body's way. */
    private static SensorView frontView(double reading) {
        return new SensorView(Vector2.ZERO, 0, Math.toRadians(10), 0.8, reading, true);
    }

    private double remembered() {
        return memory.withRememberedRange(frontView(Reading.NOTHING)).reading();
    }

    private void loseTarget(double rolled, double turned) {
        memory.update(frontView(Reading.NOTHING), rolled, turned, HALF_WIDTH);
    }

    @BeforeEach
    void seeAThingAt30Centimetres() {
        memory.update(frontView(0.3), 0, 0, HALF_WIDTH);
    }

    @Test
    void whatIsSeenIsTakenAsItIs() {
        assertEquals(0.7, memory.withRememberedRange(frontView(0.7)).reading());
    }

    @Test
    void whatIsLostComesNearerByTheWayRolled() {
        loseTarget(0.05, 0);
        loseTarget(0.15, 0);
        assertEquals(0.1, remembered(), 1e-12);
    }

    @Test
    void whatHasBeenPassedIsForgotten() {
        loseTarget(0.31, 0);
        assertFalse(memory.withRememberedRange(frontView(Reading.NOTHING)).detects());
    }

    @Test
    void whatIsNoLongerAheadIsForgotten() {
        loseTarget(0, QUARTER_TURN);
        assertEquals(Reading.NOTHING, remembered());
    }

    @Test
    void turnsToAndFroAddUp() {
        for (int i = 0; i < 90; i++) {
            loseTarget(0, QUARTER_TURN / 90 * (i % 2 == 0 ? 1 : -1));
        }
        assertEquals(Reading.NOTHING, remembered());
    }

    @Test
    void aTargetThatCanOnlyHaveLeftBesideTheBodyIsNotRemembered() {
        memory.update(frontView(0.79), 0, 0, HALF_WIDTH);
        loseTarget(0.01, 0);
        assertEquals(Reading.NOTHING, remembered(), "at 0.79 m the cone's edge is 137 mm aside, and the flank 100 mm");
    }

    @Test
    void theTipOfATargetComesNearerThoughMoreOfItIsSeenBehind() {
        memory.update(frontView(0.28), 0.1, 0, HALF_WIDTH);
        assertEquals(0.2, memory.nearest(), 1e-12, "0.3 m less the way of 0.1 m");
        assertEquals(0.28, memory.withRememberedRange(frontView(0.28)).reading(), "a reading stays a reading");
        memory.update(frontView(0.27), 0.21, 0, HALF_WIDTH);
        assertEquals(0.27, memory.nearest(), 1e-12, "the tip has been passed");
    }

    @Test
    void somethingNearerTakesThePlaceOfTheNearest() {
        memory.update(frontView(0.15), 0.1, 0, HALF_WIDTH);
        assertEquals(0.15, memory.nearest());
    }

    @Test
    void clearingForgetsBothTargets() {
        memory.clear();
        assertEquals(Reading.NOTHING, memory.nearest());
        loseTarget(0.01, 0);
        assertEquals(Reading.NOTHING, remembered());
    }

    @Test
    void aTargetBesideTheBodyIsNotTheNearestInTheWay() {
        memory.clear();
        memory.update(frontView(0.79), 0, 0, HALF_WIDTH);
        assertEquals(Reading.NOTHING, memory.nearest());
    }
}
