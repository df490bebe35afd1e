package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import java.util.Arrays;

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

    private final TrustRecord[] records;
    private final ConflictCounts conflicts;
    private int trusted;
    private double lastSuspicion = Double.NEGATIVE_INFINITY;

    /** What is remembered about one sensor; times are in seconds. */
    static final class TrustRecord {

        /** A sensor that is not trusted is tried again after this time, seconds; each further finding doubles it. */
        private static final double FIRST_PROBATION = 3;

        /**
         * The maximum of this time, seconds. It applies from the first time to a finding that takes a long time to be
         * made again.
         */
        private static final double MAX_PROBATION = 48;

        private SensorFinding finding = SensorFinding.NONE;
        /** When its trust changed last, or when it failed again while it was not trusted. */
        private double since;

        private double probation = FIRST_PROBATION;
        private boolean wasDistrusted;
        /** When it last gave no answer. */
        private double offAt = Double.NEGATIVE_INFINITY;
        /** When its reading jumped last. */
        private double jumpedAt = Double.NEGATIVE_INFINITY;
        /** When it last missed a surface that another sensor predicted. */
        private double blindAt = Double.NEGATIVE_INFINITY;
        /** The number of successive inspections in which it and another contradict only each other. */
        private int disagreement;
        /** How often others recently saw what it measured; counts decay. */
        private double confirmations;

        boolean isTrusted() {
            return finding == SensorFinding.NONE;
        }

        /** Records a reason not to trust it. */
        void distrust(SensorFinding reason, double time) {
            if (isTrusted()) {
                finding = reason;
                boolean costly = reason == SensorFinding.MISLEADING;
                probation = costly ? MAX_PROBATION : wasDistrusted ? Math.min(MAX_PROBATION, 2 * probation) : probation;
                wasDistrusted = true;
                disagreement = 0;
            }
            if (reason == SensorFinding.OFF) {
                offAt = time;
            }
            since = time;
            confirmations = 0;
        }

        /** Returns whether it has been distrusted for as long as its findings require. */
        boolean hasServedProbation(double time) {
            return time - since > probation;
        }

        /** Trusts it again. */
        void trust(double time) {
            finding = SensorFinding.NONE;
            since = time;
        }

        /** Resets the time after which it is tried again. */
        void clearHistory() {
            wasDistrusted = false;
            probation = FIRST_PROBATION;
        }

        private boolean hasJumped(double time) {
            return time - jumpedAt < JUMP_MEMORY;
        }
    }

    /**
     * Creates an assessment that trusts all sensors.
     *
     * @param sensors their number
     */
    TrustAssessment(int sensors) {
        this.records = new TrustRecord[sensors];
        Arrays.setAll(records, i -> new TrustRecord());
        this.conflicts = new ConflictCounts(sensors);
        this.trusted = (1 << sensors) - 1;
    }

    /** Returns the trusted sensors, a bit for each. */
    int trusted() {
        return trusted;
    }

    boolean allTrusted() {
        return trusted == (1 << records.length) - 1;
    }

    boolean isTrusted(int sensor) {
        return records[sensor].isTrusted();
    }

    SensorFinding finding(int sensor) {
        return records[sensor].finding;
    }

    /** Returns whether a sensor was found blind, or failed again while it was, at a moment. */
    boolean hasFoundBlind(double time) {
        for (TrustRecord sensor : records) {
            if (sensor.finding == SensorFinding.BLIND && sensor.since == time) {
                return true;
            }
        }
        return false;
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
    boolean mayBeRight(int sensor) {
        SensorFinding finding = finding(sensor);
        if (finding != SensorFinding.CONTRADICTED) {
            return finding == SensorFinding.NONE;
        }
        int against = 0;
        for (int other = 0; other < records.length; other++) {
            boolean counts = isTrusted(other) || other == sensor;
            against += counts && conflicts.pair(sensor, other) > FORGIVEN ? 1 : 0;
        }
        return against <= 1;
    }

    /** Returns when a sensor was suspicious last, seconds. */
    double lastSuspicion() {
        return lastSuspicion;
    }

    /** Records that the reading of a sensor has jumped. */
    void addJump(int sensor, double time) {
        records[sensor].jumpedAt = time;
    }

    /** Counts a surface that a sensor should see but does not. */
    void addMissedSurface(int sensor, double time) {
        conflicts.add(sensor, sensor, MISSED);
        records[sensor].blindAt = time;
    }

    /** Counts that a sensor differs from two others beside a straight wall. */
    void addDrift(int sensor) {
        conflicts.add(sensor, sensor, DRIFTED);
    }

    /** Counts that another sensor saw what a sensor measured. */
    void addConfirmation(int sensor, double weight) {
        records[sensor].confirmations += weight;
    }

    /** Trusts a sensor again, because the surface that it missed does not exist. */
    void restore(int sensor, double time) {
        conflicts.clearSelf(sensor);
        records[sensor].clearHistory();
        trust(sensor, time);
    }

    /**
     * Trusts a sensor again that gave no answer, has answered for its probation, and is not contradicted by more than a
     * trusted one may be. Others need not confirm it.
     *
     * @return whether it is trusted again
     */
    boolean trustIfAnswering(int sensor, double time) {
        TrustRecord record = records[sensor];
        boolean answers = record.finding == SensorFinding.OFF
                && record.hasServedProbation(time)
                && conflicts.against(sensor, trusted) <= THRESHOLD;
        if (answers) {
            trust(sensor, time);
        }
        return answers;
    }

    void fade(int sensor, double share) {
        conflicts.fade(sensor, share);
        records[sensor].confirmations *= share;
    }

    void assess(int sensor, double time) {
        TrustRecord record = records[sensor];
        if (record.isTrusted() && !conflicts.isActive(sensor)) {
            record.disagreement = 0;
            return;
        }
        double against = conflicts.against(sensor, trusted);
        if (against > SUSPICIOUS) {
            lastSuspicion = time;
        }
        if (record.isTrusted()) {
            record.disagreement = hasDisagreement(sensor, time) ? record.disagreement + 1 : 0;
            int most = record.hasJumped(time) ? MAX_DISAGREEMENT_AFTER_JUMP : MAX_DISAGREEMENT;
            if (against > THRESHOLD && isWorst(against) || record.disagreement > most) {
                boolean own = conflicts.pair(sensor, sensor) > against / 2;
                boolean blind = own && time - record.blindAt < BLINDNESS;
                distrust(
                        sensor,
                        blind ? SensorFinding.BLIND : own ? SensorFinding.INCONSISTENT : SensorFinding.CONTRADICTED,
                        time);
                restoreContradicted(time);
            }
        } else if (against < FORGIVEN && record.hasServedProbation(time) && record.confirmations > CONFIRMATIONS) {
            trust(sensor, time);
        }
    }

    /**
     * Returns whether a sensor and another contradict each other, but no other sensor, and the other is more credible:
     * it alone has not jumped, or others confirm it more.
     */
    private boolean hasDisagreement(int sensor, double time) {
        TrustRecord record = records[sensor];
        for (int i = 0; i < records.length; i++) {
            TrustRecord other = records[i];
            if (other.isTrusted() && conflicts.isDisagreement(sensor, i)) {
                boolean jumped = record.hasJumped(time);
                boolean lessCredible =
                        jumped == other.hasJumped(time) ? record.confirmations <= other.confirmations : jumped;
                if (lessCredible) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Trusts sensors again that were contradicted only by sensors that are no longer trusted, except those that give no
     * answer now.
     */
    private void restoreContradicted(double time) {
        for (int i = 0; i < records.length; i++) {
            TrustRecord record = records[i];
            if (record.finding == SensorFinding.CONTRADICTED
                    && record.offAt != time
                    && time - record.since < RESTORATION
                    && conflicts.against(i, trusted) < FORGIVEN) {
                trust(i, time);
            }
        }
    }

    private boolean isWorst(double against) {
        for (int i = 0; i < records.length; i++) {
            if (isTrusted(i) && conflicts.against(i, trusted) > against) {
                return false;
            }
        }
        return true;
    }

    void distrust(int sensor, SensorFinding finding, double time) {
        records[sensor].distrust(finding, time);
        trusted &= ~(1 << sensor);
    }

    private void trust(int sensor, double time) {
        records[sensor].trust(time);
        trusted |= 1 << sensor;
    }
}
