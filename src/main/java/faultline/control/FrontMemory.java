package faultline.control;

import faultline.sensor.Reading;

/**
 * Remembers what the front sensor saw last. A thin thing slips out of the cone at its edge when it is near, though it still stands in the body's way; for a while dead reckoning stands in
 * for the reading.
 */
final class FrontMemory {

    /** A turn of more than this makes what was seen worthless, radians. */
    private static final double FORGOTTEN = StrictMath.toRadians(10);

    /** The body must clear what it passes by this much, metres. */
    private static final double BERTH = 0.03;

    private double distance = Reading.NOTHING;
    private double turned;

    /** Takes a new reading after a piece of way. */
    void update(Eye front, double rolled, double turn, double halfWidth) {
        if (front.sees()) {
            // It can only be lost at the cone's edge; an edge beyond the body's flank is no danger.
            boolean inTheWay = front.reading() * StrictMath.sin(front.halfCone()) < halfWidth + BERTH;
            distance = inTheWay ? front.reading() : Reading.NOTHING;
            turned = 0;
        } else {
            distance -= rolled;
            turned += Math.abs(turn);
            if (turned > FORGOTTEN || distance < 0) {
                forget();
            }
        }
    }

    /** What was seen is dealt with. */
    void forget() {
        distance = Reading.NOTHING;
        turned = 0;
    }

    /** The front sensor with what it remembers in place of nothing. */
    Eye fill(Eye front) {
        return front.sees() ? front
                : new Eye(front.seat(), front.bearing(), front.halfCone(), front.range(), distance, front.present());
    }
}
