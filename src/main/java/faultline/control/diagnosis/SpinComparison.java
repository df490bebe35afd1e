package faultline.control.diagnosis;

import faultline.geometry.Angles;
import java.util.Arrays;

/**
 * Finds an error of a sensor that looks ahead by what others measure in the same directions during a spin. While the
 * robot turns on the spot, one sensor after the other looks at the same walls from the same place. The sensor ahead is
 * wrong if it differs from another one that agrees with a third one.
 */
final class SpinComparison extends PacedCheck {

    /** No sensor is wrong. */
    static final int NONE = -1;

    /**
     * A robot that rolls more than this while it turns by a step does not spin, metres: it drives around a corner whose
     * radius is 0.11 m or more.
     */
    private static final double MAX_ROLL = 0.004;

    /** The number of directions in which two sensors are compared at least. */
    private static final int MIN_DIRECTIONS = 3;

    /** If distances differ by more than this, one sensor is wrong, metres. */
    private static final double DIFFERS = 0.025;

    /** If distances differ by more than this, they belong to different surfaces, metres. */
    private static final double OTHER_SURFACE = 0.2;

    /** Sensors agree if they differ by less than this, metres. */
    private static final double AGREES = 0.012;

    /** If the middle half of the differences is not within this, they belong to different surfaces, metres. */
    private static final double MAX_SPREAD = 0.02;

    private final InspectedSensor[] sensors;
    private final DeadReckoning reckoning;
    private final TrustAssessment assessment;
    private final SpinLog log;
    private final SpinProfile[] profiles;
    private final double[] differences = new double[SpinProfile.DIRECTIONS];
    /** The bounds of the heading within which no sample is added. */
    private double low = Double.POSITIVE_INFINITY;

    private double high = Double.NEGATIVE_INFINITY;
    private double distanceBefore = Double.NEGATIVE_INFINITY;
    private boolean spinning;

    SpinComparison(InspectedSensor[] sensors, DeadReckoning reckoning, TrustAssessment assessment) {
        super(MotionAccumulator.Total.HEADING);
        this.sensors = sensors;
        this.reckoning = reckoning;
        this.assessment = assessment;
        this.log = new SpinLog(sensors.length);
        this.profiles = new SpinProfile[sensors.length];
        Arrays.setAll(profiles, i -> new SpinProfile());
    }

    /** Compares the sensors after a spin, unless the spin may have been a scan with few sensors. */
    @Override
    void run(double[] readings, long tick) {
        if (update(readings) && assessment.allTrusted()) {
            int wrong = wrongAhead();
            if (wrong != NONE) {
                assessment.addDrift(wrong);
            }
        }
    }

    /**
     * Processes the readings after some motion.
     *
     * @param readings the readings of all sensors
     * @return whether a spin has ended
     */
    boolean update(double[] readings) {
        double heading = reckoning.heading();
        boolean rolls = reckoning.distance() - distanceBefore > MAX_ROLL;
        if (heading <= low || heading >= high) {
            distanceBefore = reckoning.distance();
            low = Math.floor(heading / SpinProfile.STEP) * SpinProfile.STEP;
            high = low + SpinProfile.STEP;
            if (!rolls) {
                if (!spinning) {
                    log.clear();
                }
                log.add(reckoning, readings);
            }
        }
        boolean ended = spinning && rolls;
        spinning = !rolls;
        if (spinning) {
            dueAtEveryTick();
        } else {
            waitUntil(low, high);
        }
        return ended;
    }

    /** Returns the sensor ahead that is wrong by the last spin, or {@link #NONE}. */
    int wrongAhead() {
        for (SpinProfile profile : profiles) {
            profile.reset();
        }
        for (InspectedSensor sensor : sensors) {
            if (sensor.cone().looksAhead() && isWrong(sensor.index())) {
                return sensor.index();
            }
        }
        return NONE;
    }

    private boolean isWrong(int suspect) {
        boolean wrong = false;
        for (int witness = 0; witness < sensors.length; witness++) {
            double by = Math.abs(difference(suspect, witness));
            if (by < AGREES) {
                return false;
            }
            wrong |= by > DIFFERS && by < OTHER_SURFACE && isConfirmed(witness, suspect);
        }
        return wrong;
    }

    /** Returns whether a third sensor agrees with a witness and, where it can, with what the witness says. */
    private boolean isConfirmed(int witness, int suspect) {
        double by = difference(suspect, witness);
        for (int third = 0; third < sensors.length; third++) {
            if (third != suspect && Math.abs(difference(witness, third)) < AGREES) {
                double also = difference(suspect, third);
                if (Double.isNaN(also) || Math.abs(also - by) < 2 * AGREES) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Returns by how much the distances of one sensor exceed those of another, the median, metres; NaN if too few
     * belong to the same surfaces.
     */
    private double difference(int one, int other) {
        MountedCone cone = sensors[one].cone();
        MountedCone otherCone = sensors[other].cone();
        double apart = Math.abs(Angles.normalize(cone.bearing() - otherCone.bearing()));
        if (one == other || cone.half() != otherCone.half() || apart > log.turn() + SpinProfile.STEP) {
            return Double.NaN;
        }
        profiles[one].compute(sensors[one], log);
        profiles[other].compute(sensors[other], log);
        int count = profiles[one].subtract(profiles[other], differences);
        Arrays.sort(differences, 0, count);
        return count < MIN_DIRECTIONS || differences[count * 3 / 4] - differences[count / 4] > MAX_SPREAD
                ? Double.NaN
                : differences[count / 2];
    }
}
