package faultline.control;

/** FOLLOW and ROUND: steering along a wall, and around its outer corners, by the left sensor. */
final class WallSteering {

    /** A reading this much beyond the wanted one is not of the wall that is followed, metres. */
    private static final double GATE = 0.06;

    /** The innovation that counts as a bend, as a share of what a corner gives in the end. */
    private static final double BEND = 0.6;

    /**
     * How many deviations of the noise a bend is at least, in one reading and in two running. Noise is known from a hundred readings only,
     * and may be a third more than that; a run has thousands of readings.
     */
    private static final double NOISE_FACTOR = 8;
    private static final double NOISE_FACTOR_OF_TWO = 4;
    private static final double DRIFT_NOISE_FACTOR = 4;

    private final Perception perception;
    private final double wanted;
    private final WallTracker tracker = new WallTracker();
    private PdLaw law;

    WallSteering(Perception perception, double wanted) {
        this.perception = perception;
        this.wanted = wanted;
    }

    /** Starts along a wall that the robot has been aligned with. */
    void begin() {
        tracker.start(left().sees() ? left().reading() : wanted);
    }

    /** Takes the reading of a decision along a straight wall. */
    void trackWall() {
        tracker.predict(perception.rolled(), perception.turned(), 0);
        if (inSight()) {
            // Slanted to a straight wall by more than half the cone, the sensor reads the cone's edge and not the foot.
            double off = Math.max(0, Math.abs(tracker.heading()) - left().halfCone());
            tracker.correct(left().reading() * StrictMath.cos(off), perception.rolled(), radius());
        }
    }

    /** Takes the reading of a decision around an outer corner. */
    void trackCorner() {
        tracker.predict(perception.rolled(), perception.turned(), 1 / radius());
        if (inSight()) {
            tracker.correct(left().reading(), perception.rolled(), radius());
        }
    }

    /** The wall is seen to bend away: from now on its corner is tracked. */
    void takeCorner() {
        tracker.bend(-bendAngle());
    }

    /** The corner is seen to go over into a wall: from now on that is tracked. */
    void takeWall() {
        tracker.bend(bendAngle());
    }

    /** The turn rate along a straight wall. */
    double alongWall() {
        return correction();
    }

    /** The turn rate around a corner: that of the circle about it, corrected. */
    double aroundCorner() {
        return perception.robot().speed() / radius() + correction();
    }

    private double correction() {
        law = new PdLaw(perception.robot().speed(), perception.robot().motor().timeConstant() + perception.period());
        return law.turnRate(tracker.distance() - wanted, tracker.heading());
    }

    boolean inSight() {
        return left().reading() <= Math.max(tracker.distance(), wanted) + GATE;
    }

    boolean bendsAway() {
        return isBend(tracker.innovation(), tracker.innovationBefore());
    }

    boolean bendsBack() {
        return isBend(-tracker.innovation(), -tracker.innovationBefore()) || tracker.drift() < -bendDrift();
    }

    private boolean isBend(double innovation, double before) {
        double noise = perception.leftNoise();
        return innovation > bendWithoutNoise()
                && (innovation > NOISE_FACTOR * noise || Math.min(innovation, before) > NOISE_FACTOR_OF_TWO * noise);
    }

    /**
     * A straight wall that is taken for a corner gives all of the corner's innovation for as long as it lasts, so there is time to average
     * the noise away.
     */
    private double bendDrift() {
        return Math.max(bendWithoutNoise(), DRIFT_NOISE_FACTOR * perception.leftNoise() * WallTracker.driftNoise(perception.rolled()));
    }

    private double bendWithoutNoise() {
        return BEND * WallTracker.cornerInnovation(radius());
    }

    /**
     * How far the robot has gone round a corner by the time that it shows: an innovation e takes a way of sqrt(2 e r) on a circle of radius
     * r.
     */
    private double bendAngle() {
        return Math.sqrt(2 * Math.abs(tracker.innovation()) / radius());
    }

    /** From the followed wall, or the corner that is rounded, to the robot's centre, metres. */
    private double radius() {
        return Math.max(perception.robot().width() / 2, tracker.distance() + perception.seat());
    }

    private Eye left() {
        return perception.sight().left();
    }

    /** The P term of the last decision, radians per second; not a number before the first. */
    double proportional() {
        return law == null ? Double.NaN : law.proportional();
    }

    /** The D term of the last decision, radians per second; not a number before the first. */
    double derivative() {
        return law == null ? Double.NaN : law.derivative();
    }
}
