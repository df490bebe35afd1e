package faultline.engine.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The waits of a pacer whose clock is set by hand. */
class PacerTest {

    private static final double DT = 0.01;
    private static final long MILLISECOND = 1_000_000;

    /** A clock may show negative times. */
    private long now = -5000 * MILLISECOND;

    private final Pacer pacer = new Pacer(() -> now);

    private void makeTicks(int count) {
        for (int i = 0; i < count; i++) {
            pacer.tickCompleted(DT);
        }
    }

    @Test
    void atRealTimeATickIsDueAfterItsLength() {
        makeTicks(1);
        now += 4 * MILLISECOND;
        assertEquals(6 * MILLISECOND, pacer.nanosToWait());
    }

    @Test
    void atFourTimesRealTimeATickIsDueAfterAQuarterOfItsLength() {
        pacer.setSpeed(4);
        makeTicks(1);
        assertEquals(2.5 * MILLISECOND, pacer.nanosToWait());
    }

    @Test
    void atFullSpeedEveryTickIsDue() {
        pacer.setSpeed(Double.POSITIVE_INFINITY);
        makeTicks(3);
        assertEquals(0, pacer.nanosToWait());
    }

    @Test
    void upToATenthOfASecondIsCaughtUp() {
        makeTicks(1);
        now += 110 * MILLISECOND;
        assertEquals(-100 * MILLISECOND, pacer.nanosToWait());
        makeTicks(10);
        assertEquals(0, pacer.nanosToWait());
    }

    @Test
    void settingTheSpeedThatItHasStartsNoNewMeasurement() {
        makeTicks(1);
        now += 4 * MILLISECOND;
        pacer.setSpeed(1);
        assertEquals(6 * MILLISECOND, pacer.nanosToWait());
    }

    @Test
    void aLongerPauseIsNotCaughtUp() {
        makeTicks(1);
        now += 111 * MILLISECOND;
        assertEquals(-101 * MILLISECOND, pacer.nanosToWait());
        makeTicks(1);
        assertEquals(10 * MILLISECOND, pacer.nanosToWait());
    }

    @Test
    void anotherSpeedHoldsFromTheMomentOfTheChange() {
        makeTicks(5);
        pacer.setSpeed(2);
        makeTicks(1);
        assertEquals(5 * MILLISECOND, pacer.nanosToWait());
    }

    @Test
    void theAchievedSpeedIsThatOfTheLastHalfSecond() {
        now += 250 * MILLISECOND;
        makeTicks(20);
        assertEquals(0, pacer.achievedSpeed());
        now += 250 * MILLISECOND;
        makeTicks(1);
        assertEquals(0.42, pacer.achievedSpeed(), 1e-12);
        now += 500 * MILLISECOND;
        makeTicks(50);
        assertEquals(0.02, pacer.achievedSpeed(), 1e-12);
    }

    @Test
    void theAchievedSpeedIsMeasuredFromAChangeOfTheSpeedOn() {
        now += 500 * MILLISECOND;
        makeTicks(11);
        assertEquals(0.02, pacer.achievedSpeed(), 1e-12);
        pacer.setSpeed(2);
        assertEquals(0, pacer.achievedSpeed());
        now += 500 * MILLISECOND;
        makeTicks(1);
        assertEquals(0.02, pacer.achievedSpeed(), 1e-12);
    }
}
