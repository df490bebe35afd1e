package faultline.control.diagnosis;

/**
 * Tests the claims of a sensor against the map: a surface must lie somewhere on the arc at the reported distance, so
 * not all of that arc can be free.
 */
final class ClaimCheck {

    /** No contradiction. */
    static final int POSSIBLE = -1;

    /** A claimed arc is checked up to this far beyond the cone on either side, because cells are coarse, metres. */
    private static final double ARC_MARGIN = 0.025;

    private final EvidenceGrid grid;

    ClaimCheck(EvidenceGrid grid) {
        this.grid = grid;
    }

    /**
     * Returns which sensors have seen all of a claimed arc free.
     *
     * @param sensor that claims
     * @param age of the claim
     * @param oldest moment that counts
     * @param asked the sensors that count, a bit for each
     * @return their bits; 0 if none alone has seen all of it; {@link #POSSIBLE} if no sensor has seen a part of it free
     */
    int contradicting(InspectedSensor sensor, int age, int oldest, int asked) {
        ConeTable table = sensor.table();
        ClaimRing claims = sensor.claims();
        double axisCos = claims.axisCos(age);
        double axisSin = claims.axisSin(age);
        double reading = claims.reading(age);
        int all = asked;
        int i = sensor.openSample();
        for (int tested = 0; tested < ConeTable.SAMPLES; tested++) {
            double cos = table.cos(i, axisCos, axisSin);
            double sin = table.sin(i, axisCos, axisSin);
            double aside = ARC_MARGIN * ConeTable.outward(i);
            int by = grid.freeBy(
                    EvidenceGrid.cellOf(claims.x(age) + reading * cos - aside * sin),
                    EvidenceGrid.cellOf(claims.y(age) + reading * sin + aside * cos),
                    oldest,
                    asked);
            if (by == 0) {
                sensor.noteOpenSample(i);
                return POSSIBLE;
            }
            all &= by;
            i = i + 1 < ConeTable.SAMPLES ? i + 1 : 0;
        }
        return all;
    }

    /**
     * Marks the last claim in the map.
     *
     * @param sensor that claims
     * @param now the moment
     * @param oldest moment that counts
     * @param others the sensors that count, a bit for each
     * @return whether another sensor saw a surface on the claimed arc
     */
    boolean confirm(InspectedSensor sensor, int now, int oldest, int others) {
        ConeTable table = sensor.table();
        ClaimRing claims = sensor.claims();
        double axisCos = claims.axisCos(0);
        double axisSin = claims.axisSin(0);
        double reading = claims.reading(0);
        boolean found = false;
        int lastColumn = Integer.MIN_VALUE;
        int lastRow = 0;
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double x = claims.x(0) + reading * table.cos(i, axisCos, axisSin);
            double y = claims.y(0) + reading * table.sin(i, axisCos, axisSin);
            int column = EvidenceGrid.cellOf(x);
            int row = EvidenceGrid.cellOf(y);
            if (column != lastColumn || row != lastRow) {
                found = found || grid.hitBy(column, row, oldest, others) != 0;
                grid.markHit(sensor.index(), column, row, now);
                lastColumn = column;
                lastRow = row;
            }
        }
        return found;
    }
}
