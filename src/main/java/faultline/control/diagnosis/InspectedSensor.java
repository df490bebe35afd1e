package faultline.control.diagnosis;

import faultline.control.diagnosis.EvidenceGrid.RowParity;

/** A sensor under diagnosis: its mounting and its recent measurements. */
final class InspectedSensor {

    /** Sensors that look ahead or to the wall's side matter most; the evidence of others is added less often. */
    private static final double AHEAD = StrictMath.toRadians(60);

    private static final double BESIDE = StrictMath.toRadians(30);
    private static final double BACK = StrictMath.toRadians(150);
    private static final double AWAY = 0.35;

    /** A turn moves a cone sideways at this distance from the robot, metres. */
    private static final double TURN_RADIUS = 0.24;

    private final int index;
    private final MeasurementRing measurements = new MeasurementRing();
    private MountedCone cone;
    private ConeTable table;
    private double sideways;
    private boolean looksAway;
    private double markedDistance = Double.NEGATIVE_INFINITY;
    private double markedTurning;
    private RowParity rows = RowParity.ODD;
    private int inspections;
    private int markedInspections;
    private int unseenSample;

    InspectedSensor(int index, MountedCone cone) {
        this.index = index;
        refit(cone);
    }

    /** Applies changed settings. */
    void refit(MountedCone newCone) {
        if (cone == null || !newCone.equals(cone)) {
            cone = newCone;
            table = new ConeTable(newCone);
            looksAway = Math.abs(newCone.bearing()) > AHEAD && newCone.bearing() < BESIDE || newCone.bearing() > BACK;
            sideways = looksAway ? AWAY : 1;
        }
    }

    /** Returns how far its cone has moved sideways since its evidence was last added to the grid, metres. */
    double movedSinceMark(DeadReckoning reckoning) {
        return sideways * (reckoning.distance() - markedDistance) + TURN_RADIUS * (reckoning.turning() - markedTurning);
    }

    /** Returns whether straight ahead is outside its cone. */
    boolean looksAside() {
        return Math.abs(cone.bearing()) > cone.half();
    }

    /** Returns whether it looks neither ahead nor to the wall's side. */
    boolean looksAway() {
        return looksAway;
    }

    /** Records that its measurement is added to the grid, and returns the number of inspections that it represents. */
    int mark(DeadReckoning reckoning) {
        markedDistance = reckoning.distance();
        markedTurning = reckoning.turning();
        int passed = inspections - markedInspections;
        markedInspections = inspections;
        return passed;
    }

    /**
     * Returns the sample of its measured arc that no sensor had seen free in the last test: the next test most likely
     * ends there too.
     */
    int unseenSample() {
        return unseenSample;
    }

    /** Sets the sample of its measured arc that no sensor has seen free. */
    void setUnseenSample(int sample) {
        unseenSample = sample;
    }

    void countInspection() {
        inspections++;
    }

    /** Returns the rows to mark next if every second row is marked. */
    RowParity nextRows() {
        rows = rows == RowParity.EVEN ? RowParity.ODD : RowParity.EVEN;
        return rows;
    }

    /** Returns the number of inspections so far. */
    int inspections() {
        return inspections;
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
