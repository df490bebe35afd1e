package faultline.control.diagnosis;

/**
 * Tests what a sensor claims against the map: a surface must lie somewhere on the arc at the reported distance, so not
 * all of that arc can be free.
 */
final class ClaimTest {

    /** No contradiction. */
    static final int POSSIBLE = -1;

    /** A claimed arc is looked at up to this much beyond the cone on either side, because cells are coarse, metres. */
    private static final double ARC_MARGIN = 0.025;

    private final EvidenceGrid grid;

    ClaimTest(EvidenceGrid grid) {
        this.grid = grid;
    }

    /**
     * Returns which sensors have seen all of a claimed arc free.
     *
     * @param sensor that claims
     * @param age of the claim
     * @param oldest moment that counts
     * @param asked the sensors that count, a bit for each
     * @return their bits, 0 if none alone has seen all of it, {@link #POSSIBLE} if some of it was seen free by no one
     */
    int contradicting(InspectedSensor sensor, int age, int oldest, int asked) {
        ConeTable table = sensor.table();
        ClaimRing claims = sensor.claims();
        double axisCos = claims.axisCos(age);
        double axisSin = claims.axisSin(age);
        double reading = claims.reading(age);
        int all = asked;
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double cos = table.cos(i, axisCos, axisSin);
            double sin = table.sin(i, axisCos, axisSin);
            double aside = ARC_MARGIN * ConeTable.outward(i);
            int by = grid.freeBy(
                    EvidenceGrid.cellOf(claims.x(age) + reading * cos - aside * sin),
                    EvidenceGrid.cellOf(claims.y(age) + reading * sin + aside * cos),
                    oldest,
                    asked);
            if (by == 0) {
                return POSSIBLE;
            }
            all &= by;
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
        int found = 0;
        for (int i = 0; i < ConeTable.SAMPLES; i++) {
            double x = claims.x(0) + reading * table.cos(i, axisCos, axisSin);
            double y = claims.y(0) + reading * table.sin(i, axisCos, axisSin);
            found |= grid.hitBy(EvidenceGrid.cellOf(x), EvidenceGrid.cellOf(y), oldest, others);
            grid.markHit(sensor.index(), x, y, now);
        }
        return found != 0;
    }
}
