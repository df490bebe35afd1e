package faultline.control.diagnosis;

/**
 * Tests the measurements of a sensor against the map: a surface must lie somewhere on the arc at the reported distance,
 * so not all of that arc can be free.
 */
final class ArcCheck {

    /** No contradiction. */
    static final int POSSIBLE = -1;

    /** A measured arc is tested up to this far beyond the cone on either side, because cells are coarse, metres. */
    private static final double ARC_MARGIN = 0.025;

    private final EvidenceGrid grid;
    /**
     * The sample of each sensor's measured arc that no sensor had seen free in the last test: the next test most likely
     * ends there too.
     */
    private final int[] unseenSamples;

    /**
     * Creates a check.
     *
     * @param grid the map
     * @param sensors the number of sensors
     */
    ArcCheck(EvidenceGrid grid, int sensors) {
        this.grid = grid;
        this.unseenSamples = new int[sensors];
    }

    /** Returns the sample of a sensor's arc at which its next test begins. */
    int unseenSample(int sensor) {
        return unseenSamples[sensor];
    }

    /**
     * Returns which sensors have seen all of a measured arc free.
     *
     * @param sensor the sensor that measured
     * @param age the age of the measurement
     * @param oldest moment that counts
     * @param asked the sensors that count, a bit for each
     * @return their bits; 0 if none alone has seen all of it; {@link #POSSIBLE} if no sensor has seen a part of it free
     */
    int contradicting(InspectedSensor sensor, int age, int oldest, int asked) {
        ConeTable table = sensor.table();
        MeasurementRing measurements = sensor.measurements();
        double axisCos = measurements.axisCos(age);
        double axisSin = measurements.axisSin(age);
        double reading = measurements.reading(age);
        int all = asked;
        int i = unseenSamples[sensor.index()];
        for (int tested = 0; tested < ConeTable.SAMPLES; tested++) {
            double cos = table.cos(i, axisCos, axisSin);
            double sin = table.sin(i, axisCos, axisSin);
            double aside = ARC_MARGIN * ConeTable.outward(i);
            int by = grid.freeBy(
                    EvidenceGrid.cellOf(measurements.x(age) + reading * cos - aside * sin),
                    EvidenceGrid.cellOf(measurements.y(age) + reading * sin + aside * cos),
                    oldest,
                    asked);
            if (by == 0) {
                unseenSamples[sensor.index()] = i;
                return POSSIBLE;
            }
            all &= by;
            i = i + 1 < ConeTable.SAMPLES ? i + 1 : 0;
        }
        return all;
    }

    /**
     * Adds the last measurement to the grid as hit evidence.
     *
     * @param sensor the sensor that measured
     * @param now the moment
     * @param oldest moment that counts
     * @param others the sensors that count, a bit for each
     * @return whether another sensor saw a surface on the measured arc
     */
    boolean confirm(InspectedSensor sensor, int now, int oldest, int others) {
        ConeTable table = sensor.table();
        MeasurementRing measurements = sensor.measurements();
        double axisCos = measurements.axisCos(0);
        double axisSin = measurements.axisSin(0);
        double reading = measurements.reading(0);
        boolean found = false;
        int lastColumn = Integer.MIN_VALUE;
        int lastRow = 0;
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double x = measurements.x(0) + reading * table.cos(i, axisCos, axisSin);
            double y = measurements.y(0) + reading * table.sin(i, axisCos, axisSin);
            int column = EvidenceGrid.cellOf(x);
            int row = EvidenceGrid.cellOf(y);
            if (column != lastColumn || row != lastRow) {
                found = found || grid.isHit(column, row, oldest, others);
                grid.markHit(sensor.index(), column, row, now);
                lastColumn = column;
                lastRow = row;
            }
        }
        return found;
    }
}
