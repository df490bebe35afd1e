package faultline.control.wallfollower;

import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.TimingRule;
import faultline.sensor.Reading;

/**
 * TURN, MEASURE and ALIGN: spin right past the wall, time it, and turn back by the t_D / 2 rule, eq. (4) of the paper.
 */
final class AlignmentManoeuvre {

    /** A spin that begins beside a wall first backs off until the reading is this much more than the nearest. */
    private static final double BACKED_OFF_RATIO = 1.3;

    /**
     * A reading that exceeds the wanted distance by more than the greater of these when the spin begins is not of the
     * wall that was met: metres, and a multiple of the timing level's share of the wanted distance, which leaves room
     * for that level. A wall that is met farther away adds the margin of the wall ahead.
     */
    private static final double OTHER_WALL_MARGIN = 0.15;

    private static final double OTHER_WALL_LEVELS = 2;

    private static final double QUARTER_TURN = StrictMath.PI / 2;

    private final StateEstimate estimate;
    private TimingRule rule;
    private TimingRule nextRule;
    private final SpinClock clock;
    private EdgeTimer edgeTimer;
    private long startTick;
    private double startHeading;
    private double clockOrigin = Double.NaN;
    private boolean backingOff;
    private double nearestReading;
    private double remainingTurn;

    AlignmentManoeuvre(StateEstimate estimate, TimingRule rule, SpinClock clock) {
        this.estimate = estimate;
        this.rule = rule;
        this.nextRule = rule;
        this.clock = clock;
        this.edgeTimer = EdgeTimer.of(rule);
    }

    /** Sets the timing rule, which holds from the next spin. */
    void setRule(TimingRule newRule) {
        nextRule = newRule;
    }

    EdgeTimer edgeTimer() {
        return edgeTimer;
    }

    // TURN: spin right until the left sensor comes to the wall.

    /**
     * Starts a spin. If the left sensor already sees a wall that was met in a search, the robot first turns to the
     * left, away from it, so that the sensor can come to it.
     *
     * @param afterSearch whether the wall was met in a search
     */
    void begin(boolean afterSearch) {
        if (rule != nextRule) {
            rule = nextRule;
            edgeTimer = EdgeTimer.of(rule);
        }
        startHeading = estimate.odometer().heading();
        startTick = estimate.tick();
        clockOrigin = Double.NaN;
        estimate.clearFrontMemory();
        backingOff = afterSearch && wallReading() < Reading.NOTHING;
        nearestReading = left().reading();
        edgeTimer.start(
                estimate.thresholds().get(Threshold.TIMING_LEVEL),
                estimate.leftNoise(),
                estimate.isLeftNoiseKnown(),
                estimate.turnRate() * estimate.period());
        if (!backingOff) {
            edgeTimer.addApproachSample(
                    spinClock(), wallReading(), estimate.odometer().deltaDistance());
        }
    }

    /** Processes the reading of a decision in TURN. */
    void updateTurn() {
        if (!backingOff) {
            edgeTimer.addApproachSample(
                    spinClock(), wallReading(), estimate.odometer().deltaDistance());
        }
    }

    /** Decides on the turn rate of TURN, radians per second, and whether the robot still backs off. */
    double nextTurnRate() {
        if (backingOff) {
            nearestReading = Math.min(nearestReading, left().reading());
            boolean enough = rule == TimingRule.RANGE
                    ? !left().detects()
                    : left().reading() >= BACKED_OFF_RATIO * nearestReading;
            backingOff = !enough && estimate.odometer().heading() - startHeading < QUARTER_TURN;
        }
        return backingOff ? estimate.turnRate() : -estimate.turnRate();
    }

    boolean reachesWall() {
        return !backingOff && edgeTimer.reachesWall();
    }

    // MEASURE: spin on until it leaves the wall.

    /** Processes the reading of a decision in MEASURE. */
    void updateMeasure() {
        edgeTimer.updateNoise(estimate.leftNoise(), estimate.isLeftNoiseKnown());
        edgeTimer.addPassSample(spinClock(), left().reading());
        clockOrigin = estimate.tick() * estimate.dt() - spinClock();
    }

    /**
     * Returns the simulated time at which the clock of the spin would be 0 if it had run as simulated time does until
     * the last reading of MEASURE, seconds; NaN before MEASURE.
     */
    double clockOrigin() {
        return clockOrigin;
    }

    boolean leavesWall() {
        return edgeTimer.leavesWall();
    }

    // ALIGN: turn back for t_p, and wait until the spin has ended.

    /**
     * Plans the turn back: for t_p = t_D / 2 from F4 on, eq. (4). F4 is noticed a little late, and the spin continues
     * for the motors' lag until they have reversed. The robot turns back by that as well, unless the range rule
     * applies. It does not turn back by a negative angle.
     */
    void planTurnBack() {
        remainingTurn = estimate.turnRate() * edgeTimer.tP();
        if (rule == TimingRule.EQUAL_READINGS) {
            remainingTurn += estimate.turnRate() * (spinClock() - edgeTimer.tF4())
                    - estimate.odometer().omega() * estimate.motorLag();
        }
    }

    /**
     * Decides on the turn rate of ALIGN, radians per second, and reduces the remaining angle by the turn until the next
     * decision; the last decision turns just that angle.
     */
    double nextAlignTurnRate() {
        double rate = Math.max(0, Math.min(estimate.turnRate(), remainingTurn / estimate.period()));
        remainingTurn -= rate * estimate.period();
        return rate;
    }

    boolean isAligned() {
        return remainingTurn <= 0
                && Math.abs(estimate.odometer().omega()) < estimate.thresholds().radians(Threshold.SETTLED_RATE);
    }

    /**
     * Returns the left reading; infinite if it is not of the wall that was met. By the range rule every reading in
     * range counts.
     */
    private double wallReading() {
        double wanted = estimate.wantedCentreDistance();
        Thresholds thresholds = estimate.thresholds();
        double level = OTHER_WALL_LEVELS * thresholds.get(Threshold.TIMING_LEVEL);
        double margin =
                Math.max(OTHER_WALL_MARGIN, level * wanted) + Math.max(0, thresholds.get(Threshold.AHEAD_MARGIN));
        boolean counts = rule == TimingRule.RANGE || left().detectsWithin(wanted + margin);
        return counts ? left().reading() : Reading.NOTHING;
    }

    private SensorView left() {
        return estimate.left();
    }

    /** Returns the time since the spin began on the clock of t_F3, t_F4 and t_p, seconds. */
    private double spinClock() {
        return switch (clock) {
            case TURNED_ANGLE -> (startHeading - estimate.odometer().heading()) / estimate.turnRate();
            case ELAPSED_TIME -> (estimate.tick() - startTick) * estimate.dt();
        };
    }
}
