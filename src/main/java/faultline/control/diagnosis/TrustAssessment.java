package faultline.control.diagnosis;

import faultline.control.SensorFinding;

/**
 * Decides from contradictions which sensors are trusted. A sensor is no longer trusted if its count exceeds a threshold
 * and is the greatest, or if it and one other contradict only each other and others confirm that one more.
 */
final class TrustAssessment {

    private static final double THRESHOLD = 7;

    /** The count of a missed surface: two in a row exceed the threshold, because the robot may be driving at it. */
    private static final double MISSED = 5;

    /** The count of a sensor that differs from two that agree beside a wall: it exceeds the threshold alone. */
    private static final double DRIFTED = 12;

    private static final double SUSPICIOUS = 0.3;
    private static final double FORGIVEN = 0.5;
    private static final int CONFIRMATIONS = 12;

    /** The number of inspections after which one of two sensors that contradict only each other is not trusted. */
    private static final int MAX_DISAGREEMENT = 25;

    /** The same number if the reading of one of them, but not that of the other, jumped a short time ago. */
    private static final int MAX_DISAGREEMENT_AFTER_JUMP = 3;

    /** The time for which a jump explains contradictions, seconds. */
    private static final double JUMP_MEMORY = 4;

    /** A sensor that was contradicted less than this time ago may have been right, seconds. */
    private static final double RESTORATION = 6;

    /** A sensor that missed a surface less than this time ago is blind, seconds. */
    private static final double BLINDNESS = 0.5;

    private final InspectedSensor[] sensors;
    private final ConflictCounts conflicts;
    private int trusted;
    private double lastSuspicion = Double.NEGATIVE_INFINITY;

    TrustAssessment(InspectedSensor[] sensors) {
        this.sensors = sensors;
        this.conflicts = new ConflictCounts(sensors.length);
        this.trusted = (1 << sensors.length) - 1;
    }

    /** Returns the trusted sensors, a bit for each. */
    int trusted() {
        return trusted;
    }

    boolean allTrusted() {
        return trusted == (1 << sensors.length) - 1;
    }

    /** Returns the count against a sensor as a share of the threshold. */
    double evidence(int sensor) {
        return conflicts.isActive(sensor) ? conflicts.against(sensor, trusted) / THRESHOLD : 0;
    }

    /**
     * Counts a contradiction of a sensor's measurement.
     *
     * @param sensor the sensor that measured
     * @param by the sensors each of which has seen all of the measured arc free, a bit for each; 0 if only together
     * @param weight of the contradiction
     */
    void addContradiction(int sensor, int by, double weight) {
        if (by == 0) {
            conflicts.add(sensor, sensor, 0.5 * weight);
            return;
        }
        for (int rest = by; rest != 0; rest &= rest - 1) {
            conflicts.add(sensor, Integer.numberOfTrailingZeros(rest), weight);
        }
    }

    /** Returns whether a sensor is trusted, or may have been right because only one other contradicts it. */
    boolean mayBeRight(InspectedSensor sensor) {
        if (sensor.isTrusted() || sensor.finding() != SensorFinding.CONTRADICTED) {
            return sensor.isTrusted();
        }
        int against = 0;
        for (InspectedSensor other : sensors) {
            boolean counts = other.isTrusted() || other == sensor;
            against += counts && conflicts.pair(sensor.index(), other.index()) > FORGIVEN ? 1 : 0;
        }
        return against <= 1;
    }

    /** Returns when a sensor was suspicious last, seconds. */
    double lastSuspicion() {
        return lastSuspicion;
    }

    /** Counts a surface that a sensor should see but does not. */
    void addMissedSurface(InspectedSensor sensor, PredictedSurface surface, double time) {
        conflicts.add(sensor.index(), sensor.index(), MISSED);
        sensor.missSurface(surface, time);
    }

    /** Counts that a sensor differs from two others beside a straight wall. */
    void addDrift(int sensor) {
        conflicts.add(sensor, sensor, DRIFTED);
    }

    /** Trusts a sensor again, because the surface that it missed does not exist. */
    void restore(InspectedSensor sensor, double time) {
        conflicts.clearSelf(sensor.index());
        sensor.clearHistory();
        trust(sensor, time);
    }

    void fade(InspectedSensor sensor, double share) {
        conflicts.fade(sensor.index(), share);
        sensor.fadeConfirmations(share);
    }

    void assess(InspectedSensor sensor, double time) {
        if (sensor.isTrusted() && !conflicts.isActive(sensor.index())) {
            sensor.countDisagreement(false);
            return;
        }
        double against = conflicts.against(sensor.index(), trusted);
        if (against > SUSPICIOUS) {
            lastSuspicion = time;
        }
        if (sensor.isTrusted()) {
            int disagreement = sensor.countDisagreement(hasDisagreement(sensor, time));
            int most = hasJumped(sensor, time) ? MAX_DISAGREEMENT_AFTER_JUMP : MAX_DISAGREEMENT;
            if (against > THRESHOLD && isWorst(against) || disagreement > most) {
                boolean own = conflicts.pair(sensor.index(), sensor.index()) > against / 2;
                boolean blind = own && time - sensor.blindAt() < BLINDNESS;
                distrust(
                        sensor,
                        blind ? SensorFinding.BLIND : own ? SensorFinding.INCONSISTENT : SensorFinding.CONTRADICTED,
                        time);
                restoreContradicted(time);
            }
        } else if (against < FORGIVEN && sensor.hasServedProbation(time) && sensor.confirmations() > CONFIRMATIONS) {
            trust(sensor, time);
        }
    }

    /**
     * Returns whether a sensor and another contradict each other, but no other sensor, and the other is more credible:
     * it alone has not jumped, or others confirm it more.
     */
    private boolean hasDisagreement(InspectedSensor sensor, double time) {
        for (InspectedSensor other : sensors) {
            if (other.isTrusted() && conflicts.isDisagreement(sensor.index(), other.index())) {
                boolean jumped = hasJumped(sensor, time);
                boolean lessCredible =
                        jumped == hasJumped(other, time) ? sensor.confirmations() <= other.confirmations() : jumped;
                if (lessCredible) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean hasJumped(InspectedSensor sensor, double time) {
        return time - sensor.jumpedAt() < JUMP_MEMORY;
    }

    /**
     * Trusts sensors again that were contradicted only by sensors that are no longer trusted, except those that give no
     * answer now.
     */
    private void restoreContradicted(double time) {
        for (InspectedSensor sensor : sensors) {
            if (sensor.finding() == SensorFinding.CONTRADICTED
                    && sensor.offAt() != time
                    && time - sensor.since() < RESTORATION
                    && conflicts.against(sensor.index(), trusted) < FORGIVEN) {
                trust(sensor, time);
            }
        }
    }

    private boolean isWorst(double against) {
        for (InspectedSensor other : sensors) {
            if (other.isTrusted() && conflicts.against(other.index(), trusted) > against) {
                return false;
            }
        }
        return true;
    }

    void distrust(InspectedSensor sensor, SensorFinding finding, double time) {
        sensor.distrust(finding, time);
        trusted &= ~sensor.bit();
    }

    private void trust(InspectedSensor sensor, double time) {
        sensor.trust(time);
        trusted |= sensor.bit();
    }
}
