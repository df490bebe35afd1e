package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Finds an error of a sensor that looks ahead by what others measure in the same directions during a spin. While the
 * robot turns on the spot, one sensor after the other looks at the same walls from the same place. The sensor ahead is
 * wrong if it differs from another one that agrees with a third one.
 */
final class SpinComparison {

    /** No sensor is wrong. */
    static final int NONE = -1;

    /** A robot that rolls more than this while it turns by a step does not spin, metres. */
    private static final double MAX_ROLL = 0.007;

    /** The number of directions in which two sensors are compared at least. */
    private static final int MIN_DIRECTIONS = 3;

    /** If distances differ by more than this, one sensor is wrong, metres. */
    private static final double DIFFERS = 0.025;

    /** If they differ by more than this, they are of different surfaces, metres. */
    private static final double OTHER_SURFACE = 0.2;

    /** Sensors agree if they differ by less than this, metres. */
    private static final double AGREES = 0.012;

    /** The middle half of the differences is within this, or they are of different surfaces, metres. */
    private static final double MAX_SPREAD = 0.02;

    private final InspectedSensor[] sensors;
    private final DeadReckoning reckoning;
    private final SpinProfile[] profiles;
    private final double[] differences = new double[SpinProfile.DIRECTIONS];
    /** The bounds of the heading up to which nothing is added. */
    private double low = Double.POSITIVE_INFINITY;

    private double high = Double.NEGATIVE_INFINITY;
    private double distanceBefore = Double.NEGATIVE_INFINITY;
    private double centreX;
    private double centreY;
    private boolean spinning;

    SpinComparison(InspectedSensor[] sensors, DeadReckoning reckoning) {
        this.sensors = sensors;
        this.reckoning = reckoning;
        this.profiles = new SpinProfile[sensors.length];
        Arrays.setAll(profiles, i -> new SpinProfile());
    }

    /**
     * Processes the readings after some motion.
     *
     * @param readings the readings of all sensors
     * @return whether a spin has ended
     */
    boolean update(double[] readings) {
        double heading = reckoning.heading();
        boolean turned = heading <= low || heading >= high;
        if (!turned && !spinning) {
            return false;
        }
        boolean rolls = reckoning.distance() - distanceBefore > MAX_ROLL;
        if (turned) {
            distanceBefore = reckoning.distance();
            low = Math.floor(heading / SpinProfile.STEP) * SpinProfile.STEP;
            high = low + SpinProfile.STEP;
            if (!rolls) {
                add(readings);
            }
        }
        boolean ended = spinning && rolls;
        spinning = !rolls;
        return ended;
    }

    private void add(double[] readings) {
        if (!spinning) {
            centreX = reckoning.x();
            centreY = reckoning.y();
            for (SpinProfile profile : profiles) {
                profile.clear();
            }
        }
        double dx = reckoning.x() - centreX;
        double dy = reckoning.y() - centreY;
        for (InspectedSensor sensor : sensors) {
            double cos = sensor.table().axisCos(reckoning.headingCos(), reckoning.headingSin());
            double sin = sensor.table().axisSin(reckoning.headingCos(), reckoning.headingSin());
            double reading = readings[sensor.index()];
            boolean sees = reading < sensor.cone().range();
            profiles[sensor.index()].add(
                    reckoning.heading() + sensor.cone().bearing(), sees ? reading + dx * cos + dy * sin : Double.NaN);
        }
    }

    /** Returns the sensor ahead that is wrong by the last spin, or {@link #NONE}. */
    int wrongAhead() {
        for (InspectedSensor sensor : sensors) {
            boolean looksAhead =
                    Math.abs(sensor.cone().bearing()) < sensor.cone().half();
            if (looksAhead && isWrong(sensor.index())) {
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
     * Returns by how much the distances of one sensor exceed those of another, the median, metres; not a number if too
     * few are of the same surfaces.
     */
    private double difference(int one, int other) {
        if (one == other || sensors[one].cone().half() != sensors[other].cone().half()) {
            return Double.NaN;
        }
        profiles[one].compute(sensors[one].cone());
        profiles[other].compute(sensors[other].cone());
        int count = 0;
        for (int i = 0; i < SpinProfile.DIRECTIONS; i++) {
            double by = profiles[one].distance(i) - profiles[other].distance(i);
            if (!Double.isNaN(by)) {
                differences[count++] = by;
            }
        }
        Arrays.sort(differences, 0, count);
        return count < MIN_DIRECTIONS || differences[count * 3 / 4] - differences[count / 4] > MAX_SPREAD
                ? Double.NaN
                : differences[count / 2];
    }
}
