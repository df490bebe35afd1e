package faultline.control.diagnosis;

/**
 * Compares the sensors that see the wall beside the robot at regular distances along the path. It finds a drifting one
 * and estimates by how much the curvature of the path exceeds that of the motor model, which corrects the dead
 * reckoning. Where a surface that may cross the path is near, it restores the full rate of inspections, because the
 * next inspection at a lower rate may be too late.
 */
final class WallComparison extends PacedCheck {

    /** The distance between two samples, metres. */
    private static final double STEP = 0.015;

    private final MotionAccumulator motion;
    private final DeadReckoning reckoning;
    private final TrustAssessment assessment;
    private final SensorInspection inspection;
    private final JumpCheck jumpCheck;
    private final WallAgreement agreement = new WallAgreement();
    private final CurvatureEstimate curvature = new CurvatureEstimate();
    private WallLine line;
    /** The distance and the heading at the last sample. */
    private double distance;

    private double heading;

    WallComparison(
            MotionAccumulator motion,
            DeadReckoning reckoning,
            TrustAssessment assessment,
            SensorInspection inspection,
            JumpCheck jumpCheck) {
        super(MotionAccumulator.Total.DISTANCE);
        this.motion = motion;
        this.reckoning = reckoning;
        this.assessment = assessment;
        this.inspection = inspection;
        this.jumpCheck = jumpCheck;
        waitForNext();
    }

    private void waitForNext() {
        waitUntil(distance - STEP, distance + STEP);
    }

    /** Sets the sensors on the wall's side, which may be new or have new settings. */
    void refit(WallLine newLine) {
        line = newLine;
    }

    /**
     * Records that the reading of a sensor has jumped. If it is one on the wall's side, only distances from here on are
     * compared, and all sensors are inspected more often for a while. If it is the one that faces a wall that was
     * straight so far, the jump is checked.
     */
    void jump(InspectedSensor sensor) {
        if (line.contains(sensor)) {
            if (line.sensor(WallLine.BESIDE) == sensor && agreement.isStraight()) {
                jumpCheck.begin(line, agreement.wallDistance());
            }
            agreement.restart(motion.netDistance(), motion.heading());
            inspection.attend();
        }
    }

    @Override
    void run(double[] readings, long tick) {
        double rolled = motion.netDistance() - distance;
        double turned = motion.heading() - heading;
        distance = motion.netDistance();
        heading = motion.heading();
        waitForNext();
        if (inspection.isClose(readings)) {
            inspection.hasten();
        }
        double sag = line.sag(readings, assessment.trusted());
        curvature.update(line.distance(readings), sag, rolled, turned - curvature.curvature() * rolled);
        reckoning.setCurvature(curvature.curvature());
        int differs = agreement.update(line, readings, distance, heading);
        if (differs != WallAgreement.NONE) {
            assessment.addDrift(line.sensor(differs).index());
            inspection.attend();
        }
    }
}
