package faultline.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.geometry.Vec;
import faultline.sensor.Reading;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class FrontMemoryTest {

    private static final double HALF_WIDTH = 0.1;
    private static final double QUARTER = Math.PI / 2;

    private final FrontMemory memory = new FrontMemory();

    /** A cone of 20 degrees: at 0.3 m its edge is 52 mm aside, in the body's way. */
    private static Eye front(double reading) {
        return new Eye(Vec.ZERO, 0, Math.toRadians(10), 0.8, reading, true);
    }

    private double remembered() {
        return memory.fill(front(Reading.NOTHING)).reading();
    }

    private void lose(double rolled, double turned) {
        memory.update(front(Reading.NOTHING), rolled, turned, HALF_WIDTH);
    }

    @BeforeEach
    void seeAThingAt30Centimetres() {
        memory.update(front(0.3), 0, 0, HALF_WIDTH);
    }

    @Test
    void whatIsSeenIsTakenAsItIs() {
        assertEquals(0.7, memory.fill(front(0.7)).reading());
    }

    @Test
    void whatIsLostComesNearerByTheWayRolled() {
        lose(0.05, 0);
        lose(0.15, 0);
        assertEquals(0.1, remembered(), 1e-12);
    }

    @Test
    void whatHasBeenPassedIsForgotten() {
        lose(0.31, 0);
        assertFalse(memory.fill(front(Reading.NOTHING)).sees());
    }

    @Test
    void whatIsNoLongerAheadIsForgotten() {
        lose(0, QUARTER);
        assertEquals(Reading.NOTHING, remembered());
    }

    @Test
    void turnsToAndFroAddUp() {
        for (int i = 0; i < 90; i++) {
            lose(0, QUARTER / 90 * (i % 2 == 0 ? 1 : -1));
        }
        assertEquals(Reading.NOTHING, remembered());
    }

    @Test
    void aThingThatCanOnlyHaveLeftBesideTheBodyIsNotRemembered() {
        memory.update(front(0.79), 0, 0, HALF_WIDTH);
        lose(0.01, 0);
        assertEquals(Reading.NOTHING, remembered(), "at 0.79 m the cone's edge is 137 mm aside, and the flank 100 mm");
    }

    @Test
    void theTipOfAThingComesNearerThoughMoreOfItIsSeenBehind() {
        memory.update(front(0.28), 0.1, 0, HALF_WIDTH);
        assertEquals(0.2, memory.nearest(), 1e-12, "0.3 m less the way of 0.1 m");
        assertEquals(0.28, memory.fill(front(0.28)).reading(), "a reading stays a reading");
        memory.update(front(0.27), 0.21, 0, HALF_WIDTH);
        assertEquals(0.27, memory.nearest(), 1e-12, "the tip has been passed");
    }

    @Test
    void somethingNearerTakesThePlaceOfTheNearest() {
        memory.update(front(0.15), 0.1, 0, HALF_WIDTH);
        assertEquals(0.15, memory.nearest());
    }

    @Test
    void itForgetsWhenTold() {
        memory.forget();
        assertEquals(Reading.NOTHING, memory.nearest());
        lose(0.01, 0);
        assertEquals(Reading.NOTHING, remembered());
    }
}
