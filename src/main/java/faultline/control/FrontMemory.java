package faultline.control;

import faultline.sensor.Reading;

/**
 * Remembers what the front sensor saw last. A thin thing slips out of the cone at its edge when it is near, though it still stands in the
 * body's way; for a while dead reckoning stands in for the reading.
 */
final class FrontMemory {

    /** A turn of more than this makes what was seen worthless, radians. */
    private static final double FORGOTTEN = StrictMath.toRadians(10);

    /** The body must clear what it passes by this much, metres. */
    private static final double BERTH = 0.03;

    private final Thing last = new Thing();
    private final Thing nearest = new Thing();

    /** Something seen ahead, as far as dead reckoning knows. */
    private static final class Thing {

        private double distance = Reading.NOTHING;
        private double turned;

        void see(double reading) {
            distance = reading;
            turned = 0;
        }

        void age(double rolled, double turn) {
            distance -= rolled;
            turned += Math.abs(turn);
            if (turned > FORGOTTEN || distance < 0) {
                distance = Reading.NOTHING;
            }
        }
    }

    /** Takes a new reading after a piece of way. */
    void update(Eye front, double rolled, double turn, double halfWidth) {
        last.age(rolled, turn);
        nearest.age(rolled, turn);
        if (front.sees()) {
            // It can only be lost at the cone's edge; an edge beyond the body's flank is no danger.
            boolean inTheWay = front.reading() * StrictMath.sin(front.halfCone()) < halfWidth + BERTH;
            last.see(inTheWay ? front.reading() : Reading.NOTHING);
            if (inTheWay && front.reading() <= nearest.distance) {
                nearest.see(front.reading());
            }
        }
    }

    /** What was seen is dealt with. */
    void forget() {
        last.see(Reading.NOTHING);
        nearest.see(Reading.NOTHING);
    }

    /**
     * How far ahead of the sensor the nearest thing in the way is, metres, though the tip of it may have slipped out of the cone and more
     * of it be seen behind.
     */
    double nearest() {
        return nearest.distance;
    }

    /** The front sensor with what it remembers in place of nothing. */
    Eye fill(Eye front) {
        return front.sees() ? front
                : new Eye(front.seat(), front.bearing(), front.halfCone(), front.range(), last.distance, front.present());
    }
}
