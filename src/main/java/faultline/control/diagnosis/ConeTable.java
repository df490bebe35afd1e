package faultline.control.diagnosis;

/** The directions in a sensor's cone in which its measurements are tested, relative to its axis, computed once. */
final class ConeTable {

    /** The number of points on a measured arc that are tested. */
    static final int SAMPLES = 7;

    private final double[] cos = new double[SAMPLES];
    private final double[] sin = new double[SAMPLES];
    /** The cosine of the bearing of the edge nearer to straight ahead, an angle to either side. */
    private final double innerCos;

    private final double innerSin;
    private final double bearingCos;
    private final double bearingSin;

    ConeTable(MountedCone cone) {
        double inner = Math.abs(cone.bearing()) - cone.half();
        innerCos = StrictMath.cos(inner);
        innerSin = StrictMath.sin(inner);
        bearingCos = StrictMath.cos(cone.bearing());
        bearingSin = StrictMath.sin(cone.bearing());
        for (int i = 0; i < SAMPLES; i++) {
            double offset = cone.half() * (2.0 * i / (SAMPLES - 1) - 1);
            cos[i] = StrictMath.cos(offset);
            sin[i] = StrictMath.sin(offset);
        }
    }

    double axisCos(double headingCos, double headingSin) {
        return headingCos * bearingCos - headingSin * bearingSin;
    }

    double axisSin(double headingCos, double headingSin) {
        return headingSin * bearingCos + headingCos * bearingSin;
    }

    double cos(int sample, double axisCos, double axisSin) {
        return axisCos * cos[sample] - axisSin * sin[sample];
    }

    double sin(int sample, double axisCos, double axisSin) {
        return axisSin * cos[sample] + axisCos * sin[sample];
    }

    /**
     * Returns the direction in which a point at the border of the cone is moved out of it: -1, 1, or 0 for one inside.
     */
    static int outward(int sample) {
        return sample == 0 ? -1 : sample == SAMPLES - 1 ? 1 : 0;
    }

    /** Returns the cosine of the angle between straight ahead and the edge nearer to it. */
    double innerCos() {
        return innerCos;
    }

    /** Returns the sine of that angle. */
    double innerSin() {
        return innerSin;
    }

    double cosHalf() {
        return cos[SAMPLES - 1];
    }
}
