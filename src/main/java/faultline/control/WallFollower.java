package faultline.control;

import static faultline.control.FollowerState.ALIGN;
import static faultline.control.FollowerState.FOLLOW;
import static faultline.control.FollowerState.MEASURE;
import static faultline.control.FollowerState.ROUND;
import static faultline.control.FollowerState.SEARCH;
import static faultline.control.FollowerState.TURN;

import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import java.util.List;

/**
 * The paper's six-state wall follower with PD distance control and the t_p = t_D / 2 orientation rule. It works in a frame in which the wall is kept on the
 * left; the other hand is its mirror image.
 *
 * <p>The state diagram is the table {@link #TRANSITIONS}: of the arrows that leave a state, the first whose condition holds is taken, at most one a decision.
 */
final class WallFollower implements Controller {

    /** The paper's Fig. 8 as we read it. */
    static final List<Transition> TRANSITIONS = List.of(
            new Transition(SEARCH, TURN, "wall met", WallFollower::wallMet),
            new Transition(TURN, MEASURE, "left sensor comes to the wall (F3)", WallFollower::comesToWall),
            new Transition(TURN, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(MEASURE, ALIGN, "left sensor leaves the wall (F4)", WallFollower::leavesWall),
            new Transition(MEASURE, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(ALIGN, FOLLOW, "turned back for t_p, spin died out", WallFollower::aligned),
            new Transition(FOLLOW, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(FOLLOW, ROUND, "wall ended", WallFollower::wallEnded),
            new Transition(ROUND, TURN, "wall ahead", WallFollower::wallAhead),
            new Transition(ROUND, FOLLOW, "wall seen again", WallFollower::wallSeenAgain),
            new Transition(ROUND, SEARCH, "turned all round without a wall", WallFollower::wallLost));

    /** More than a whole turn: what has not been seen by then is not there. */
    private static final double ALL_ROUND = StrictMath.toRadians(400);

    /** ALIGN hands over below this rate, radians per second. */
    private static final double STILL = StrictMath.toRadians(1);

    /** A spin that begins beside a wall first backs off until the reading is this much more than the nearest. */
    private static final double BACKED_OFF = 1.3;

    /** A wall at the far front corner is turned from when it is this near to the circle that the platform turns in, metres. */
    private static final double GUARD = 0.06;

    /** A reading this much beyond the wanted one is not of the wall that is followed, metres. */
    private static final double GATE = 0.06;

    /** The innovation that counts as a bend, as a share of what a corner gives in the end. */
    private static final double BEND = 0.6;

    /** Around a corner the robot does not slow down below this share of its speed. */
    private static final double SLOWEST = 0.3;

    private final ControllerSpec.WallFollowing spec;
    private final Odometer odometer = new Odometer();
    private final WallTracker tracker = new WallTracker();
    private final SpinTiming timing = new SpinTiming();
    private final FrontMemory frontMemory = new FrontMemory();
    private final NoiseMeter leftNoise = new NoiseMeter();
    private final NoiseMeter frontNoise = new NoiseMeter();

    private FollowerState state = SEARCH;
    private String condition = "";
    private long since;
    private int transitions;
    private double entryHeading;
    private double spinStart;

    private Observation now;
    private Sight sight;
    private PdLaw law;
    private long lastTick;
    private double v;
    private double omega;
    private boolean backingOff;
    private double nearestBackingOff;
    private double remaining;

    WallFollower(ControllerSpec.WallFollowing spec) {
        this.spec = spec;
    }

    @Override
    public Decision decide(Observation observation) {
        look(observation);
        for (Transition transition : TRANSITIONS) {
            if (transition.from() == state && transition.holds().test(this)) {
                enter(transition);
                break;
            }
        }
        act();
        return decision();
    }

    private void look(Observation observation) {
        long ticks = observation.tick() - lastTick;
        lastTick = observation.tick();
        now = observation;
        odometer.advance(observation.robot(), v, omega, observation.dt(), ticks);
        sight = remembering(Sight.of(observation, spec.hand()));
        law = new PdLaw(observation.robot().speed(), observation.robot().motor().timeConstant() + observation.dt());
        if (state == FOLLOW || state == ROUND) {
            track();
        } else if (state == TURN && !backingOff) {
            timing.approach(spinClock(), sight.left().reading());
        } else if (state == MEASURE) {
            timing.pass(spinClock(), sight.left().reading());
        }
    }

    private Sight remembering(Sight fresh) {
        leftNoise.learn(fresh.left().reading());
        frontNoise.learn(fresh.front().reading());
        frontMemory.update(fresh.front(), odometer.rolled(), odometer.turned(), robot().width() / 2);
        return fresh.withFront(frontMemory.fill(fresh.front()));
    }

    private void track() {
        tracker.predict(odometer.rolled(), odometer.turned(), state == ROUND ? 1 / radius() : 0);
        if (wallInSight()) {
            tracker.correct(footDistance(), odometer.rolled(), radius());
        }
    }

    /** The distance of the wall's foot: with the robot slanted to a straight wall by more than half the cone, the reading is of the cone's edge. */
    private double footDistance() {
        double off = state == FOLLOW ? Math.max(0, Math.abs(tracker.heading()) - sight.left().halfCone()) : 0;
        return sight.left().reading() * StrictMath.cos(off);
    }

    private void enter(Transition transition) {
        state = transition.to();
        condition = transition.condition();
        since = now.tick();
        transitions++;
        entryHeading = odometer.heading();
        switch (state) {
            case TURN -> enterTurn(transition.from());
            case ALIGN -> enterAlign();
            case FOLLOW -> enterFollow(transition.from());
            case ROUND -> tracker.bend(-bendAngle());
            default -> { }
        }
    }

    private void act() {
        switch (state) {
            case SEARCH -> drive(robot().speed(), 0);
            case TURN -> turn();
            case MEASURE -> drive(0, -turnRate());
            case ALIGN -> align();
            case FOLLOW -> steer(law.turnRate(tracker.distance() - spec.distance(), tracker.heading()));
            case ROUND -> round();
        }
    }

    // SEARCH: drive on until a wall is seen.

    private boolean wallMet() {
        double near = wantedRadius() + stopping();
        return wallAheadWithin(WallAhead.MOST_IN_THE_OPEN, WallAhead.MOST_IN_THE_OPEN)
                || isWithin(near, sight.frontLeft()) || isWithin(near, sight.frontRight())
                || isWithin(wantedRadius(), sight.left()) || isWithin(wantedRadius(), sight.right());
    }

    /** Whether a sensor sees a wall that, if the axis meets it squarely, is within a distance of the robot's centre. */
    private static boolean isWithin(double distance, Eye eye) {
        return eye.sees() && eye.squareDistance() <= distance;
    }

    // TURN: spin right until the left sensor comes to the wall.

    private void enterTurn(FollowerState from) {
        spinStart = odometer.heading();
        frontMemory.forget();
        backingOff = from == SEARCH && sight.left().sees();
        nearestBackingOff = sight.left().reading();
        timing.start(noise());
        if (!backingOff) {
            timing.approach(spinClock(), sight.left().reading());
        }
    }

    private void turn() {
        if (backingOff) {
            nearestBackingOff = Math.min(nearestBackingOff, sight.left().reading());
            backingOff = sight.left().reading() < BACKED_OFF * nearestBackingOff && turnedSinceEntry() < StrictMath.PI / 2;
        }
        drive(0, backingOff ? turnRate() : -turnRate());
    }

    private boolean comesToWall() {
        return !backingOff && timing.comesToWall();
    }

    private boolean turnedAllRound() {
        return -turnedSinceEntry() > ALL_ROUND;
    }

    // MEASURE: spin on until the left sensor leaves the wall.

    private boolean leavesWall() {
        return timing.leavesWall();
    }

    // ALIGN: turn back for t_p, and let the spin die out.

    /** eq. (4) with what the motors' lag takes: the turn back begins a lag after F4 was noticed, and the spin to the right goes on for as long. */
    private void enterAlign() {
        double sinceF4 = spinClock() - timing.tF4();
        double back = turnRate() * (timing.tP() + sinceF4);
        remaining = back - odometer.omega(robot()) * Odometer.lag(robot(), now.dt());
    }

    private void align() {
        double rate = Math.max(0, Math.min(turnRate(), remaining / period()));
        remaining -= rate * period();
        drive(0, rate);
    }

    private boolean aligned() {
        return remaining <= 0 && Math.abs(odometer.omega(robot())) < STILL;
    }

    // FOLLOW: PD distance control along the wall.

    private void enterFollow(FollowerState from) {
        if (from == ROUND) {
            tracker.bend(bendAngle());
        } else {
            tracker.start(sight.left().sees() ? sight.left().reading() : spec.distance());
        }
    }

    private boolean wallAhead() {
        return wallAheadWithin(WallAhead.MOST_LEFT, WallAhead.MOST_RIGHT) || isWithin(robot().reach() + GUARD, sight.frontRight());
    }

    private boolean wallAheadWithin(double mostLeft, double mostRight) {
        return WallAhead.distanceAfter(stopping(), sight, mostLeft, mostRight) <= wantedRadius();
    }

    /** The way that the robot still rolls after it is told to stop, metres. */
    private double stopping() {
        return robot().speed() * (Odometer.lag(robot(), now.dt()) + now.dt());
    }

    private boolean wallEnded() {
        return !wallInSight() || tracker.innovation() > bendInnovation();
    }

    // ROUND: arc around the outer corner until the wall is seen again.

    private void round() {
        if (wallInSight()) {
            double around = robot().speed() / radius();
            steer(around + law.turnRate(tracker.distance() - spec.distance(), tracker.heading()));
        } else {
            drive(robot().speed() / 2, turnRate());
        }
    }

    private boolean wallSeenAgain() {
        return wallInSight() && tracker.innovation() < -bendInnovation();
    }

    private boolean wallLost() {
        return !wallInSight() && turnedSinceEntry() > ALL_ROUND;
    }

    // What the states share.

    private boolean wallInSight() {
        return sight.left().reading() <= Math.max(tracker.distance(), spec.distance()) + GATE;
    }

    /** From the followed wall, or the corner that is rounded, to the robot's centre, metres. */
    private double radius() {
        return Math.max(robot().width() / 2, tracker.distance() + sight.left().seat().y());
    }

    private double wantedRadius() {
        return spec.distance() + sight.left().seat().y();
    }

    private double bendInnovation() {
        return Math.max(BEND * WallTracker.cornerInnovation(radius()), 5 * noise());
    }

    /** How far the robot has gone round a corner by the time that the corner shows: an innovation e takes a way of sqrt(2 e r) on a circle of radius r. */
    private double bendAngle() {
        return Math.sqrt(2 * Math.abs(tracker.innovation()) / radius());
    }

    private double noise() {
        return Math.max(leftNoise.deviation(), frontNoise.deviation());
    }

    private double turnedSinceEntry() {
        return odometer.heading() - entryHeading;
    }

    /** The time that spinning right at the constant rate takes to come to the present heading, seconds. */
    private double spinClock() {
        return (spinStart - odometer.heading()) / turnRate();
    }

    private RobotSpec robot() {
        return now.robot();
    }

    private double period() {
        return now.dt() * Periodic.ticks(spec.period(), now.dt());
    }

    private double turnRate() {
        return Math.min(robot().turnRate(), 2 * robot().motor().maxSpeed() / robot().track());
    }

    /** Rolls at the robot's speed along a bend; where the bend is too tight for the turn rate, slower, so that the bend stays. */
    private void steer(double rate) {
        double share = Math.max(SLOWEST, Math.min(1, turnRate() / Math.abs(rate)));
        drive(share * robot().speed(), Math.max(-turnRate(), Math.min(turnRate(), rate)));
    }

    private void drive(double newV, double newOmega) {
        v = newV;
        omega = newOmega;
    }

    private Decision decision() {
        MotorSpec motor = robot().motor();
        double half = omega * robot().track() / 2;
        double near = motor.voltageFor(v - half);
        double far = motor.voltageFor(v + half);
        return spec.hand() == Hand.LEFT ? new Decision(near, far, telemetry()) : new Decision(far, near, telemetry());
    }

    private Telemetry telemetry() {
        boolean steering = state == FOLLOW || state == ROUND;
        return new Telemetry(state.name(), condition, since, transitions, spec.distance(), sight.left().reading(),
                steering ? law.proportional() : Double.NaN, steering ? law.derivative() : Double.NaN,
                timing.tF3(), timing.tF4(), timing.tP());
    }
}
