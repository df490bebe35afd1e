package faultline.control.diagnosis;

/**
 * The last measurements of one sensor: the pose of its cone, and its reading; the reading is negative if it saw
 * nothing.
 */
final class MeasurementRing {

    /** A power of two. */
    private static final int SIZE = 32;

    private static final int FIELDS = 7;

    private final double[] data = new double[SIZE * FIELDS];
    private int count;
    private int forgotten;

    void add(double x, double y, double axis, double axisCos, double axisSin, double reading, double clock) {
        int slot = (count++ & SIZE - 1) * FIELDS;
        data[slot] = x;
        data[slot + 1] = y;
        data[slot + 2] = axis;
        data[slot + 3] = axisCos;
        data[slot + 4] = axisSin;
        data[slot + 5] = reading;
        data[slot + 6] = clock;
    }

    /** Forgets all measurements; they still count as added. */
    void forget() {
        forgotten = count;
    }

    /** Returns the number of measurements that were ever added. */
    int count() {
        return count;
    }

    /** Returns whether there is a measurement of some age, counted in measurements, 0 for the last. */
    boolean has(int age) {
        return age < Math.min(count - forgotten, SIZE);
    }

    private double field(int age, int field) {
        return data[(count - 1 - age & SIZE - 1) * FIELDS + field];
    }

    double x(int age) {
        return field(age, 0);
    }

    double y(int age) {
        return field(age, 1);
    }

    double axis(int age) {
        return field(age, 2);
    }

    double axisCos(int age) {
        return field(age, 3);
    }

    double axisSin(int age) {
        return field(age, 4);
    }

    double reading(int age) {
        return field(age, 5);
    }

    double clock(int age) {
        return field(age, 6);
    }
}
