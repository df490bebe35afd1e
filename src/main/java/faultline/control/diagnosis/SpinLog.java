package faultline.control.diagnosis;

/** The readings of all sensors during a spin with the poses at which they were measured, in the order of time. */
final class SpinLog {

    /** The maximum number of entries; more than those of a turn. */
    private static final int CAPACITY = 2 * SpinProfile.DIRECTIONS;

    private final int sensors;
    private final double[] readings;
    private final double[] headings = new double[CAPACITY];
    private final double[] headingCos = new double[CAPACITY];
    private final double[] headingSin = new double[CAPACITY];
    private final double[] x = new double[CAPACITY];
    private final double[] y = new double[CAPACITY];
    private int added;
    private double least;
    private double greatest;

    SpinLog(int sensors) {
        this.sensors = sensors;
        this.readings = new double[sensors * CAPACITY];
    }

    /** Forgets all entries. */
    void clear() {
        added = 0;
        least = Double.POSITIVE_INFINITY;
        greatest = Double.NEGATIVE_INFINITY;
    }

    /** Adds an entry; the oldest one is dropped if there are too many. */
    void add(DeadReckoning pose, double[] all) {
        int entry = added++ % CAPACITY;
        headings[entry] = pose.heading();
        least = Math.min(least, pose.heading());
        greatest = Math.max(greatest, pose.heading());
        headingCos[entry] = pose.headingCos();
        headingSin[entry] = pose.headingSin();
        x[entry] = pose.x();
        y[entry] = pose.y();
        System.arraycopy(all, 0, readings, entry * sensors, sensors);
    }

    /** Returns the number of entries. */
    int size() {
        return Math.min(added, CAPACITY);
    }

    /** Returns the angle between the outermost headings, radians. */
    double turn() {
        return greatest - least;
    }

    private int entry(int place) {
        return added <= CAPACITY ? place : (added + place) % CAPACITY;
    }

    /** Returns the direction of a sensor's axis in an entry, radians, not normalised. */
    double direction(int place, MountedCone cone) {
        return headings[entry(place)] + cone.bearing();
    }

    /**
     * Returns the distance that a sensor measured in an entry, along its axis from the robot's position in the oldest
     * one that is kept, metres; not a number if it saw nothing.
     */
    double distance(int place, InspectedSensor sensor) {
        int entry = entry(place);
        double reading = readings[entry * sensors + sensor.index()];
        if (!(reading < sensor.cone().range())) {
            return Double.NaN;
        }
        int first = entry(0);
        double cos = sensor.table().axisCos(headingCos[entry], headingSin[entry]);
        double sin = sensor.table().axisSin(headingCos[entry], headingSin[entry]);
        return reading + (x[entry] - x[first]) * cos + (y[entry] - y[first]) * sin;
    }
}
