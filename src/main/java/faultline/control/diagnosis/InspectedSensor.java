package faultline.control.diagnosis;

/** A sensor under diagnosis: its mounting and its recent measurements. */
final class InspectedSensor {

    private final int index;
    private final MeasurementRing measurements = new MeasurementRing();
    private MountedCone cone;
    private ConeTable table;

    /**
     * Creates a sensor without measurements.
     *
     * @param index its place in the robot's list of sensors
     * @param cone its cone
     */
    InspectedSensor(int index, MountedCone cone) {
        this.index = index;
        refit(cone);
    }

    /** Applies changed settings. */
    void refit(MountedCone newCone) {
        if (cone == null || !newCone.equals(cone)) {
            cone = newCone;
            table = new ConeTable(newCone);
            // A surface that the earlier cone saw need not lie on an arc of this one.
            measurements.forget();
        }
    }

    /** Returns its index in the robot's list of sensors. */
    int index() {
        return index;
    }

    /** Returns the bit with its index. */
    int bit() {
        return 1 << index;
    }

    MeasurementRing measurements() {
        return measurements;
    }

    MountedCone cone() {
        return cone;
    }

    ConeTable table() {
        return table;
    }
}
