package faultline.control.diagnosis;

import java.util.Arrays;

/**
 * Finds an error of the sensor that faces the wall by a jump of its reading. Where the robot drives along a straight
 * wall, a step of the wall, or an object at it, reaches the sensor ahead first. If the reading jumps nevertheless, and
 * the sensors ahead and behind still measure the distance that all three measured before, the sensor is wrong.
 */
final class JumpCheck extends PacedCheck {

    /** The time after a jump over which the distances are averaged, seconds. */
    private static final double DURATION = 0.1;

    /** A distance is still the one before if it differs by less than this, metres. */
    private static final double AGREES = 0.02;

    /** The maximum turn during the check, radians. */
    private static final double MAX_TURN = StrictMath.toRadians(12);

    private final MotionAccumulator motion;
    private final TrustAssessment assessment;
    private final SensorInspection inspection;
    private final double[] sums = new double[WallLine.SENSORS];
    private WallLine line;
    /** The distance from the robot's centre to the wall before the jump, metres. */
    private double before;

    private double startTime;
    private double startHeading;
    private int count;

    JumpCheck(MotionAccumulator motion, TrustAssessment assessment, SensorInspection inspection) {
        super(MotionAccumulator.Total.TIME);
        this.motion = motion;
        this.assessment = assessment;
        this.inspection = inspection;
        stop();
    }

    private void stop() {
        waitUntil(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /**
     * Begins the check, because the reading of the sensor that faces the wall has jumped.
     *
     * @param checked the sensors on the wall's side
     * @param distance the distance from the robot's centre to the wall that all three measured before, metres
     */
    void begin(WallLine checked, double distance) {
        line = checked;
        before = distance;
        startTime = motion.time();
        startHeading = motion.heading();
        Arrays.fill(sums, 0);
        count = 0;
        dueAtEveryTick();
    }

    @Override
    void run(double[] readings, long tick) {
        double turn = motion.heading() - startHeading;
        if (!line.isSeen(readings) || Math.abs(turn) > MAX_TURN) {
            stop();
            return;
        }
        for (int i = 0; i < WallLine.SENSORS; i++) {
            sums[i] += line.aside(i, readings, turn);
        }
        count++;
        if (motion.time() - startTime >= DURATION) {
            stop();
            if (isWrong()) {
                assessment.addDrift(line.sensor(WallLine.BESIDE).index());
                inspection.attend();
            }
        }
    }

    /** Returns whether the sensor that faces the wall differs from the distance before, and the others do not. */
    private boolean isWrong() {
        boolean wrong = true;
        for (int i = 0; i < WallLine.SENSORS; i++) {
            double by = Math.abs(sums[i] / count - before);
            wrong &= i == WallLine.BESIDE ? by > WallAgreement.DIFFERS : by < AGREES;
        }
        return wrong;
    }
}
