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
 * The paper's six-state wall follower with PD distance control and the t_p = t_D / 2 orientation rule. It works in a frame in which the
 * wall is kept on the left; the other hand is its mirror image.
 *
 * <p>The state diagram is the table {@link #TRANSITIONS}: of the arrows that leave a state, the first whose condition holds is taken, at
 * most one a decision.
 */
final class WallFollower implements Controller {

    /** The paper's Fig. 8 as we read it. */
    static final List<Transition> TRANSITIONS = List.of(
            new Transition(SEARCH, TURN, "wall met", WallFollower::wallMet),
            new Transition(TURN, MEASURE, "left sensor comes to the wall (F3)", follower -> follower.spin.comesToWall()),
            new Transition(TURN, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(MEASURE, ALIGN, "left sensor leaves the wall (F4)", follower -> follower.spin.leavesWall()),
            new Transition(MEASURE, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(ALIGN, FOLLOW, "turned back for t_p, spin died out", follower -> follower.spin.aligned()),
            new Transition(FOLLOW, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(FOLLOW, ROUND, "wall ended", WallFollower::wallEnded),
            new Transition(ROUND, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(ROUND, FOLLOW, "wall seen again", WallFollower::wallSeenAgain),
            new Transition(ROUND, SEARCH, "turned all round", WallFollower::wallLost));

    /** The state that it begins in. */
    static final FollowerState FIRST = SEARCH;

    /** More than a whole turn: what has not been seen by then is not there. */
    private static final double ALL_ROUND = StrictMath.toRadians(400);

    /**
     * What is at the far front corner, or slipped out of the front cone, is turned from when it is this near to the circle that the
     * platform turns in, metres.
     */
    private static final double GUARD = 0.06;

    /**
     * A spin that ends within this of the heading at which it began has found the same wall again: the slight corner ahead does not show
     * apart from it, so the robot steers through by the left sensor, and looks out for walls ahead only after this way.
     */
    private static final double SAME_HEADING = StrictMath.toRadians(15);
    private static final double STEERED_THROUGH = 0.15;

    /** A bend too tight for the turn rate slows the robot down, but not below this share of its speed. */
    private static final double SLOWEST = 0.3;

    private final ControllerSpec.WallFollowing spec;
    private final Perception perception;
    private final SpinManoeuvre spin;
    private final WallSteering steering;

    private FollowerState state = FIRST;
    private String condition = "";
    private long since;
    private int transitions;
    private double entryHeading;
    private double spinHeading = Double.NaN;
    private double steerThrough;
    private double v;
    private double omega;

    WallFollower(ControllerSpec.WallFollowing spec) {
        this.spec = spec;
        perception = new Perception(spec);
        spin = new SpinManoeuvre(perception, spec.timing());
        steering = new WallSteering(perception, spec.distance());
    }

    @Override
    public Decision decide(Observation observation) {
        perception.look(observation, v, omega);
        takeReading();
        for (Transition transition : TRANSITIONS) {
            if (transition.from() == state && transition.holds().test(this)) {
                enter(transition);
                break;
            }
        }
        act();
        return decision();
    }

    private void takeReading() {
        switch (state) {
            case SEARCH -> perception.glimpse();
            case TURN -> spin.approach();
            case MEASURE -> spin.pass();
            case FOLLOW -> follow();
            case ROUND -> steering.trackCorner();
            default -> { }
        }
    }

    private void follow() {
        steering.trackWall();
        steerThrough -= perception.rolled();
    }

    private void enter(Transition transition) {
        state = transition.to();
        condition = transition.condition();
        since = perception.tick();
        transitions++;
        entryHeading = perception.heading();
        switch (state) {
            case TURN -> enterTurn(transition.from());
            case ALIGN -> spin.turnBack();
            case FOLLOW -> enterFollow(transition.from());
            case ROUND -> steering.takeCorner();
            default -> { }
        }
    }

    private void enterTurn(FollowerState from) {
        spinHeading = from == SEARCH ? Double.NaN : perception.heading();
        spin.begin(from == SEARCH);
    }

    private void enterFollow(FollowerState from) {
        if (from == ROUND) {
            steering.takeWall();
        } else {
            steering.begin();
            // Not a number after a search, which has followed no wall yet.
            boolean sameWall = Math.abs(Angles.difference(spinHeading, perception.heading())) < SAME_HEADING;
            steerThrough = sameWall ? STEERED_THROUGH : 0;
        }
    }

    private void act() {
        switch (state) {
            case SEARCH -> drive(perception.robot().speed(), 0);
            case TURN -> drive(0, spin.turnRate());
            case MEASURE -> drive(0, -perception.turnRate());
            case ALIGN -> drive(0, spin.alignRate());
            case FOLLOW -> steer(steering.alongWall());
            case ROUND -> round();
        }
    }

    /** Around a corner in sight, on a circle about it; if it has slipped behind, in a tight bend until it is back. */
    private void round() {
        if (steering.inSight()) {
            steer(steering.aroundCorner());
        } else {
            drive(perception.robot().speed() / 2, perception.turnRate());
        }
    }

    /** Rolls at the robot's speed along a bend; where the bend is too tight for the turn rate, slower, so that the bend stays. */
    private void steer(double rate) {
        double most = perception.turnRate();
        double share = Math.max(SLOWEST, Math.min(1, most / Math.abs(rate)));
        drive(share * perception.robot().speed(), Math.max(-most, Math.min(most, rate)));
    }

    private void drive(double newV, double newOmega) {
        v = newV;
        omega = newOmega;
    }

    // The conditions of the transitions.

    private boolean wallMet() {
        Sight sight = perception.sight();
        double radius = perception.wantedRadius();
        double near = radius + perception.stopping();
        return perception.wallAheadInTheOpen()
                || perception.inTheWay(perception.robot().reach() + GUARD) || perception.glimpsedWithin(radius)
                || sight.frontLeft().seesWithin(near) || sight.frontRight().seesWithin(near)
                || sight.left().seesWithin(radius) || sight.right().seesWithin(radius);
    }

    private boolean wallAhead() {
        double guarded = perception.robot().reach() + GUARD;
        return steerThrough <= 0 && perception.wallAheadBesideAWall()
                || perception.inTheWay(guarded) || perception.sight().frontRight().seesWithin(guarded);
    }

    private boolean wallEnded() {
        return !steering.inSight() || steering.bendsAway();
    }

    private boolean wallSeenAgain() {
        return steering.inSight() && steering.bendsBack();
    }

    private boolean wallLost() {
        return !steering.inSight() && turnedAllRound();
    }

    private boolean turnedAllRound() {
        return Math.abs(perception.heading() - entryHeading) > ALL_ROUND;
    }

    private Decision decision() {
        MotorSpec motor = perception.robot().motor();
        double half = omega * perception.robot().track() / 2;
        double near = motor.voltageFor(v - half);
        double far = motor.voltageFor(v + half);
        return spec.hand() == Hand.LEFT ? new Decision(near, far, telemetry()) : new Decision(far, near, telemetry());
    }

    private Telemetry telemetry() {
        SpinTiming timing = spin.timing();
        return new Telemetry(state.name(), condition, since, transitions, spec.distance(), perception.sight().left().reading(),
                steering.proportional(), steering.derivative(), timing.tF3(), timing.tF4(), timing.tP());
    }
}
