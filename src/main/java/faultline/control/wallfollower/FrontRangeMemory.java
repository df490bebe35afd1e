package faultline.control.wallfollower;

import faultline.sensor.Reading;

/**
 * Remembers the last reading of the front sensor. A thin object leaves the cone at its edge when it is near, although
 * it still blocks the robot's path; until the robot has passed it, dead reckoning replaces the reading.
 */
final class FrontRangeMemory {

    /** A turn of more than this invalidates the remembered reading, radians. */
    private static final double MAX_TURN = StrictMath.toRadians(10);

    /** The robot must pass obstacles at this distance, metres. */
    private static final double MIN_CLEARANCE = 0.03;

    private final Target latestTarget = new Target();
    private final Target nearest = new Target();

    /** An object that was seen ahead, with its position by dead reckoning. */
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

    /** Processes a reading after some motion. */
    void update(SensorView front, double rolled, double turn, double halfWidth) {
        latestTarget.advance(rolled, turn);
        nearest.advance(rolled, turn);
        if (front.detects()) {
            // It can leave the cone only at its edge; an edge beyond the robot's side is not dangerous.
            boolean inTheWay = front.reading() * StrictMath.sin(front.halfCone()) < halfWidth + MIN_CLEARANCE;
            latestTarget.set(inTheWay ? front.reading() : Reading.NOTHING);
            if (inTheWay && front.reading() <= nearest.distance) {
                nearest.set(front.reading());
            }
        }
    }

    /** Forgets what was seen. */
    void clear() {
        latestTarget.set(Reading.NOTHING);
        nearest.set(Reading.NOTHING);
    }

    /**
     * Returns the distance from the sensor to the nearest object in the way, metres, even if its tip has left the cone
     * and only a part behind it is seen.
     */
    double nearest() {
        return nearest.distance;
    }

    /** Returns the front sensor with the remembered reading if it sees nothing. */
    SensorView withRememberedRange(SensorView front) {
        return front.detects() ? front : front.withReading(latestTarget.distance);
    }
}
