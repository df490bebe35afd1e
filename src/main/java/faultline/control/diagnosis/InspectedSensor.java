package faultline.control.diagnosis;

import faultline.control.SensorFinding;
import faultline.control.diagnosis.EvidenceGrid.RowParity;

/** A sensor under diagnosis: its mounting, its recent measurements, and the findings against it. */
final class InspectedSensor {

    /** A sensor that is not trusted is tried again after this time, seconds; each further finding doubles it. */
    private static final double FIRST_PROBATION = 3;

    /**
     * The maximum of this time, seconds. It applies from the first time to a finding that takes a long time to be made
     * again.
     */
    private static final double MAX_PROBATION = 48;

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
    private SensorFinding finding = SensorFinding.NONE;
    private double since;
    private double offAt = Double.NEGATIVE_INFINITY;
    private double probation = FIRST_PROBATION;
    private boolean wasDistrusted;
    private double confirmations;
    private int disagreement;
    private double blindAt = -1;
    private double jumpedAt = Double.NEGATIVE_INFINITY;
    private PredictedSurface missed;
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

    SensorFinding finding() {
        return finding;
    }

    boolean isTrusted() {
        return finding == SensorFinding.NONE;
    }

    /** Returns when its trust changed last, or when it failed again while it was not trusted, seconds. */
    double since() {
        return since;
    }

    /** Returns whether it has been distrusted for as long as its findings require. */
    boolean hasServedProbation(double time) {
        return time - since > probation;
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

    /** Returns when it last gave no answer, seconds. */
    double offAt() {
        return offAt;
    }

    /** Resets the time after which it is tried again. */
    void clearHistory() {
        wasDistrusted = false;
        probation = FIRST_PROBATION;
    }

    /** Trusts it again. */
    void trust(double time) {
        finding = SensorFinding.NONE;
        since = time;
    }

    /** Returns how often others recently saw what it measured; counts decay. */
    double confirmations() {
        return confirmations;
    }

    void confirm(double weight) {
        confirmations += weight;
    }

    void fadeConfirmations(double share) {
        confirmations *= share;
    }

    /** Counts the successive inspections in which it and another contradict only each other, and returns the count. */
    int countDisagreement(boolean stands) {
        disagreement = stands ? disagreement + 1 : 0;
        return disagreement;
    }

    /** Records that its reading jumped. */
    void jump(double time) {
        jumpedAt = time;
    }

    /** Returns when its reading jumped last, seconds. */
    double jumpedAt() {
        return jumpedAt;
    }

    /** Records that it did not see what another sensor predicted. */
    void missSurface(PredictedSurface surface, double time) {
        missed = surface;
        blindAt = time;
    }

    /** Returns what it did not see last, null if there is none. */
    PredictedSurface missed() {
        return missed;
    }

    /** Returns when it last did not see what another sensor predicted, seconds. */
    double blindAt() {
        return blindAt;
    }
}
