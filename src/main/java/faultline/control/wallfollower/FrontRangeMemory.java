package faultline.control.wallfollower;

import faultline.sensor.Reading;

/**
 * Remembers what the front sensor saw last. A thin thing slips out of the cone at its edge when it is near, though it
 * still stands in the body's way; for a while dead reckoning stands in for the reading.
 */
final class FrontRangeMemory {

    /** A turn of more than this makes what was seen worthless, radians. */
    private static final double MAX_TURN = StrictMath.toRadians(10);

    /** The body must clear what it passes by this much, metres. */
    private static final double MIN_CLEARANCE = 0.03;

    private final Target latestTarget = new Target();
    private final Target nearest = new Target();

    /** Something seen ahead, as far as dead reckoning knows. */
    private static final class Target {

        private double distance = Reading.NOTHING;
        private double accumulatedTurn;

        void set(double reading) {
            distance = reading;
            accumulatedTurn = 0;
        }

        void advance(double rolled, double turn) {
            distance -= rolled;
            accumulatedTurn += Math.abs(turn);
            if (accumulatedTurn > MAX_TURN || distance < 0) {
                distance = Reading.NOTHING;
            }
        }
    }

    /** Takes a new reading after a piece of way. */
    void update(SensorView front, double rolled, double turn, double halfWidth) {
        latestTarget.advance(rolled, turn);
        nearest.advance(rolled, turn);
        if (front.detects()) {
            // It can only be lost at the cone's edge; an edge beyond the body's flank is no danger.
            boolean inTheWay = front.reading() * StrictMath.sin(front.halfCone()) < halfWidth + MIN_CLEARANCE;
            latestTarget.set(inTheWay ? front.reading() : Reading.NOTHING);
            if (inTheWay && front.reading() <= nearest.distance) {
                nearest.set(front.reading());
            }
        }
    }

    /** What was seen is dealt with. */
    void clear() {
        latestTarget.set(Reading.NOTHING);
        nearest.set(Reading.NOTHING);
    }

    /**
     * How far ahead of the sensor the nearest thing in the way is, metres, though the tip of it may have slipped out of
     * the cone and more of it be seen behind.
     */
    double nearest() {
        return nearest.distance;
    }

    /** The front sensor with what it remembers in place of nothing. */
    SensorView withRememberedRange(SensorView front) {
        return front.detects()
                ? front
                : new SensorView(
                        front.mountPosition(),
                        front.bearing(),
                        front.halfCone(),
                        front.range(),
                        latestTarget.distance,
                        front.present());
    }
}
