package faultline.control;

import static faultline.control.FollowerState.ALIGN;
import static faultline.control.FollowerState.FOLLOW;
import static faultline.control.FollowerState.MEASURE;
import static faultline.control.FollowerState.ROUND;
import static faultline.control.FollowerState.SEARCH;
import static faultline.control.FollowerState.TURN;

import faultline.geometry.Angles;
import faultline.robot.MotorSpec;
import java.util.List;

/**
 * The paper's six-state wall follower with PD distance control and the t_p = t_D / 2 orientation rule. It works in a
 * frame in which the wall is kept on the left; the other hand is its mirror image.
 *
 * <p>The state diagram is the table {@link #TRANSITIONS}: of the arrows that leave a state, the first whose condition
 * holds is taken, at most one a decision.
 */
public final class WallFollower implements Controller {

    /** The paper's Fig. 8 as we read it. */
    static final List<Transition> TRANSITIONS = List.of(
            new Transition(SEARCH, TURN, "wall met", WallFollower::wallMet),
            new Transition(
                    TURN, MEASURE, "left sensor comes to the wall (F3)", follower -> follower.alignment.reachesWall()),
            new Transition(TURN, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(
                    MEASURE, ALIGN, "left sensor leaves the wall (F4)", follower -> follower.alignment.leavesWall()),
            new Transition(MEASURE, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(
                    ALIGN, FOLLOW, "turned back for t_p, spin died out", follower -> follower.alignment.isAligned()),
            new Transition(FOLLOW, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(FOLLOW, ROUND, "wall ended", WallFollower::wallEnded),
            new Transition(ROUND, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(ROUND, FOLLOW, "wall seen again", WallFollower::wallSeenAgain),
            new Transition(ROUND, SEARCH, "turned all round", WallFollower::wallLost));

    /** The state that it begins in. */
    static final FollowerState INITIAL_STATE = SEARCH;

    /** More than a whole turn: what has not been seen by then is not there. */
    private static final double MAX_SPIN = StrictMath.toRadians(400);

    /**
     * What is at the far front corner, or slipped out of the front cone, is turned from when it is this near to the
     * circle that the platform turns in, metres.
     */
    private static final double CORNER_CLEARANCE = 0.06;

    /**
     * A spin that ends within this of the heading at which it began has found the same wall again: the slight corner
     * ahead does not show apart from it, so the robot steers through by the left sensor, and looks out for walls ahead
     * only after this way.
     */
    private static final double SAME_HEADING_TOLERANCE = StrictMath.toRadians(15);

    private static final double STEER_THROUGH_DISTANCE = 0.15;

    /** A bend too tight for the turn rate slows the robot down, but not below this share of its speed. */
    private static final double MIN_SPEED_SHARE = 0.3;

    private final ControllerSpec.WallFollowing spec;
    private final StateEstimate estimate;
    private final AlignmentManoeuvre alignment;
    private final WallSteering steering;

    private FollowerState state = INITIAL_STATE;
    private String condition = "";
    private long sinceTick;
    private int transitions;
    private double entryHeading;
    private double spinHeading = Double.NaN;
    private double remainingSteerThrough;
    private double v;
    private double omega;

    public WallFollower(ControllerSpec.WallFollowing spec) {
        this.spec = spec;
        estimate = new StateEstimate(spec);
        alignment = new AlignmentManoeuvre(estimate, spec.timingRule());
        steering = new WallSteering(estimate, spec.distance());
    }

    @Override
    public Decision decide(Observation observation) {
        estimate.update(observation, v, omega);
        processReading();
        for (Transition transition : TRANSITIONS) {
            if (transition.from() == state && transition.guard().test(this)) {
                enter(transition);
                break;
            }
        }
        updateCommand();
        return decision();
    }

    private void processReading() {
        switch (state) {
            case SEARCH -> estimate.updateLastSeenPoints();
            case TURN -> alignment.updateTurn();
            case MEASURE -> alignment.updateMeasure();
            case FOLLOW -> trackWall();
            case ROUND -> steering.trackCorner();
            default -> {}
        }
    }

    private void trackWall() {
        steering.trackWall();
        remainingSteerThrough -= estimate.deltaDistance();
    }

    private void enter(Transition transition) {
        state = transition.to();
        condition = transition.condition();
        sinceTick = estimate.tick();
        transitions++;
        entryHeading = estimate.heading();
        switch (state) {
            case TURN -> enterTurn(transition.from());
            case ALIGN -> alignment.planTurnBack();
            case FOLLOW -> enterFollow(transition.from());
            case ROUND -> steering.switchToCorner();
            default -> {}
        }
    }

    private void enterTurn(FollowerState from) {
        spinHeading = from == SEARCH ? Double.NaN : estimate.heading();
        alignment.begin(from == SEARCH);
    }

    private void enterFollow(FollowerState from) {
        if (from == ROUND) {
            steering.switchToWall();
        } else {
            steering.begin();
            // Not a number after a search, which has followed no wall yet.
            boolean sameWall = Math.abs(Angles.difference(spinHeading, estimate.heading())) < SAME_HEADING_TOLERANCE;
            remainingSteerThrough = sameWall ? STEER_THROUGH_DISTANCE : 0;
        }
    }

    private void updateCommand() {
        switch (state) {
            case SEARCH -> setCommand(estimate.robot().speed(), 0);
            case TURN -> setCommand(0, alignment.turnRate());
            case MEASURE -> setCommand(0, -estimate.turnRate());
            case ALIGN -> setCommand(0, alignment.alignTurnRate());
            case FOLLOW -> steer(steering.wallTurnRate());
            case ROUND -> driveAroundCorner();
        }
    }

    /** Around a corner in sight, on a circle about it; if it has slipped behind, in a tight bend until it is back. */
    private void driveAroundCorner() {
        if (steering.isWallInSight()) {
            steer(steering.cornerTurnRate());
        } else {
            setCommand(estimate.robot().speed() / 2, estimate.turnRate());
        }
    }

    /**
     * Rolls at the robot's speed along a bend; where the bend is too tight for the turn rate, slower, so that the bend
     * stays.
     */
    private void steer(double rate) {
        double most = estimate.turnRate();
        double share = Math.max(MIN_SPEED_SHARE, Math.min(1, most / Math.abs(rate)));
        setCommand(share * estimate.robot().speed(), Math.max(-most, Math.min(most, rate)));
    }

    private void setCommand(double newV, double newOmega) {
        v = newV;
        omega = newOmega;
    }

    // The conditions of the transitions.

    private boolean wallMet() {
        SensorViews sight = estimate.views();
        double radius = estimate.wantedCentreDistance();
        double near = radius + estimate.stoppingDistance();
        return estimate.isWallAheadWhileSearching()
                || estimate.isFrontTargetWithin(estimate.robot().boundingRadius() + CORNER_CLEARANCE)
                || estimate.isLastSeenPointWithin(radius)
                || sight.frontLeft().detectsWithin(near)
                || sight.frontRight().detectsWithin(near)
                || sight.left().detectsWithin(radius)
                || sight.right().detectsWithin(radius);
    }

    private boolean wallAhead() {
        double guarded = estimate.robot().boundingRadius() + CORNER_CLEARANCE;
        return remainingSteerThrough <= 0 && estimate.isWallAheadWhileFollowing()
                || estimate.isFrontTargetWithin(guarded)
                || estimate.views().frontRight().detectsWithin(guarded);
    }

    private boolean wallEnded() {
        return !steering.isWallInSight() || steering.bendsAway();
    }

    private boolean wallSeenAgain() {
        return steering.isWallInSight() && steering.bendsBack();
    }

    private boolean wallLost() {
        return !steering.isWallInSight() && turnedAllRound();
    }

    private boolean turnedAllRound() {
        return Math.abs(estimate.heading() - entryHeading) > MAX_SPIN;
    }

    private Decision decision() {
        MotorSpec motor = estimate.robot().motor();
        double half = omega * estimate.robot().track() / 2;
        double near = motor.voltageFor(v - half);
        double far = motor.voltageFor(v + half);
        return spec.side() == WallSide.LEFT
                ? new Decision(near, far, telemetry())
                : new Decision(far, near, telemetry());
    }

    private Telemetry telemetry() {
        EdgeTimer timing = alignment.edgeTimer();
        return new Telemetry(
                state.name(),
                condition,
                sinceTick,
                transitions,
                spec.distance(),
                estimate.views().left().reading(),
                steering.proportional(),
                steering.derivative(),
                timing.tF3(),
                timing.tF4(),
                timing.tP());
    }
}
