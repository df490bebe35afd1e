package faultline.control.diagnosis;

/**
 * Estimates beside straight walls how much the curvature of the path exceeds that of the motor model, from one reading
 * for each centimetre of the path, and corrects the dead reckoning.
 */
final class PathCurvature extends PacedCheck {

    /** The distance between two samples, metres. */
    private static final double STEP = 0.01;

    private final MotionAccumulator motion;
    private final DeadReckoning reckoning;
    private final CurvatureEstimate curvature = new CurvatureEstimate();
    private WallLine line;
    /** The distance and the heading at the last sample. */
    private double distance;

    private double heading;

    PathCurvature(MotionAccumulator motion, DeadReckoning reckoning) {
        super(MotionAccumulator.Total.DISTANCE);
        this.motion = motion;
        this.reckoning = reckoning;
        waitForNext();
    }

    private void waitForNext() {
        waitUntil(distance - STEP, distance + STEP);
    }

    /** Sets the sensors on the wall's side, which may be new or have new settings. */
    void refit(WallLine newLine) {
        line = newLine;
    }

    @Override
    void run(double[] readings, long tick) {
        double rolled = motion.netDistance() - distance;
        double turned = motion.heading() - heading;
        distance = motion.netDistance();
        heading = motion.heading();
        waitForNext();
        curvature.update(line.distance(readings), line.sag(readings), rolled, turned - curvature.curvature() * rolled);
        reckoning.setCurvature(curvature.curvature());
    }
}
