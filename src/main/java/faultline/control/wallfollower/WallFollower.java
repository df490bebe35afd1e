package faultline.control.wallfollower;

import static faultline.control.FollowerState.ALIGN;
import static faultline.control.FollowerState.FOLLOW;
import static faultline.control.FollowerState.MEASURE;
import static faultline.control.FollowerState.ROUND;
import static faultline.control.FollowerState.SEARCH;
import static faultline.control.FollowerState.TURN;

import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.control.Successor;
import faultline.control.Telemetry;
import faultline.control.Threshold;
import faultline.control.WallSide;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The paper's six-state wall follower with PD distance control and the t_p = t_D / 2 orientation rule. It works in a
 * frame in which the wall is kept on the left; the other side is its mirror image.
 *
 * <p>The state diagram is the table {@link #TRANSITIONS}: of the transitions that leave a state, the first whose guard
 * holds is taken, at most one for each decision.
 */
public final class WallFollower implements Successor {

    /** The paper's Fig. 8 by our interpretation, decision 0002. */
    static final List<Transition> TRANSITIONS = List.of(
            new Transition(SEARCH, TURN, "wall met", follower -> follower.search.isWallMet()),
            new Transition(
                    TURN, MEASURE, "left sensor comes to the wall (F3)", follower -> follower.alignment.reachesWall()),
            new Transition(TURN, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(
                    MEASURE, ALIGN, "left sensor leaves the wall (F4)", follower -> follower.alignment.leavesWall()),
            new Transition(MEASURE, SEARCH, "turned all round", WallFollower::turnedAllRound),
            new Transition(
                    ALIGN, FOLLOW, "turned back for t_p, spin died out", follower -> follower.alignment.isAligned()),
            new Transition(FOLLOW, TURN, "wall ahead", follower -> follower.wall.isWallAhead()),
            new Transition(FOLLOW, ROUND, "wall ended", follower -> follower.wall.isWallEnded()),
            new Transition(ROUND, TURN, "wall ahead", follower -> follower.wall.isWallAhead()),
            new Transition(ROUND, FOLLOW, "wall seen again", follower -> follower.wall.isWallSeenAgain()),
            new Transition(
                    ROUND,
                    SEARCH,
                    "turned all round",
                    follower -> !follower.wall.isWallInSight() && follower.turnedAllRound()));

    /** A sensor looks in one of the follower's directions if its bearing differs by less than this, radians. */
    public static final double FACING_TOLERANCE = StrictMath.toRadians(20);

    /** The transitions that leave each state: a decision looks at no others. */
    private static final Map<FollowerState, List<Transition>> OUTGOING = outgoing();

    /** The state in which the follower starts. */
    static final FollowerState INITIAL_STATE = SEARCH;

    /** A curve that is too tight for the turn rate slows the robot down, but not below this share of its speed. */
    private static final double MIN_SPEED_SHARE = 0.3;

    private ControllerSpec.WallFollowing spec;
    private final Odometer odometer;
    private final StateEstimate estimate;
    private final AlignmentManoeuvre alignment;
    private final SearchState search;
    private final WallStates wall;
    private final Map<FollowerState, StateBehaviour> behaviours = new EnumMap<>(FollowerState.class);

    private FollowerState state = INITIAL_STATE;
    private StateBehaviour behaviour;
    private List<Transition> outgoing = OUTGOING.get(INITIAL_STATE);
    private String condition = "";
    private long sinceTick;
    private int transitions;
    private double entryHeading;
    /** The last decision, and its tick, if the follower updates its odometer itself. */
    private Decision last = new Decision(0, 0, Telemetry.ofState(INITIAL_STATE));

    private long lastTick;

    /**
     * Creates a follower in its initial state.
     *
     * @param spec its settings
     */
    public WallFollower(ControllerSpec.WallFollowing spec) {
        this(spec, SpinClock.TURNED_ANGLE);
    }

    /**
     * Creates a follower in its initial state.
     *
     * @param spec its settings
     * @param clock the clock of the times F3, F4 and t_p
     */
    public WallFollower(ControllerSpec.WallFollowing spec, SpinClock clock) {
        this(spec, clock, new Odometer());
    }

    /**
     * Creates a follower in its initial state that shares an odometer.
     *
     * @param spec its settings
     * @param odometer the odometer of the robot's motion, which its owner updates before each decision
     */
    public WallFollower(ControllerSpec.WallFollowing spec, Odometer odometer) {
        this(spec, SpinClock.TURNED_ANGLE, odometer);
    }

    private WallFollower(ControllerSpec.WallFollowing spec, SpinClock clock, Odometer odometer) {
        this.spec = spec;
        this.odometer = odometer;
        entryHeading = odometer.heading();
        estimate = new StateEstimate(spec, odometer);
        alignment = new AlignmentManoeuvre(estimate, spec.timingRule(), clock);
        search = new SearchState(estimate);
        SpinStates spin = new SpinStates(estimate, alignment);
        wall = new WallStates(estimate, spin, spec.distance(), spec.gainRule());
        behaviours.put(SEARCH, search);
        behaviours.put(TURN, spin.turn());
        behaviours.put(MEASURE, spin.measure());
        behaviours.put(ALIGN, spin.align());
        behaviours.put(FOLLOW, wall.follow());
        behaviours.put(ROUND, wall.round());
        behaviour = search;
    }

    /**
     * {@return the distance from the robot's centre to the mounting position of the sensor that faces the wall, metres;
     * half the width of the platform if no sensor does}
     *
     * @param side the side of the wall
     * @param robot the robot
     */
    public static double sideMountOffset(WallSide side, RobotSpec robot) {
        return StateEstimate.sideMountOffset(side, robot);
    }

    /**
     * {@return the distance from the robot's centre to the wall at which the sensor that faces the wall reads the
     * wanted distance, metres, at least half the width of the platform}
     *
     * @param spec the settings of the follower
     * @param robot the robot; if no sensor faces the wall, the distance is that from the side of the platform
     */
    public static double wantedCentreDistance(ControllerSpec.WallFollowing spec, RobotSpec robot) {
        return StateEstimate.wantedCentreDistance(spec, robot);
    }

    /**
     * {@return the velocity on a curve: more slowly where the robot cannot turn fast enough, so that the curve stays
     * the same, but not below a share of the speed}
     *
     * @param speed the speed on a curve on which the robot can turn fast enough, metres per second
     * @param rate the turn rate of the curve at that speed, radians per second, positive to the left
     * @param maxRate the greatest turn rate of the robot, radians per second, positive
     */
    public static Velocity onCurve(double speed, double rate, double maxRate) {
        double share = Math.max(MIN_SPEED_SHARE, Math.min(1, maxRate / Math.abs(rate)));
        return new Velocity(share * speed, Math.max(-maxRate, Math.min(maxRate, rate)));
    }

    @Override
    public void begin(long tick, WheelSpeeds wheels) {
        lastTick = tick;
        odometer.setWheels(spec.side().nearAndFar(wheels));
    }

    @Override
    public Decision decide(Observation observation) {
        odometer.advance(
                observation.robot(),
                last.nearVolts(spec.side()),
                last.farVolts(spec.side()),
                observation.dt(),
                observation.tick() - lastTick);
        lastTick = observation.tick();
        last = decide(observation, Telemetry.Diagnosis.NONE);
        return last;
    }

    /**
     * Decides after the odometer has been updated, and shows the result of a diagnosis.
     *
     * @param observation the newest
     * @param diagnosis the trust in the sensors
     * @return the decision
     */
    public Decision decide(Observation observation, Telemetry.Diagnosis diagnosis) {
        estimate.update(observation);
        behaviour.processReading();
        for (Transition transition : outgoing) {
            if (transition.guard().test(this)) {
                enter(transition);
                break;
            }
        }
        wall.clearTerms();
        Velocity velocity = behaviour.nextVelocity();
        return Decision.ofVelocity(estimate.robot(), spec.side(), velocity, telemetry(diagnosis));
    }

    @Override
    public void configure(ControllerSpec.BuiltIn settings) {
        spec = spec.changedTo(settings);
        estimate.configure(spec);
        alignment.setRule(spec.timingRule());
        wall.configure(spec.distance(), spec.gainRule());
    }

    private void enter(Transition transition) {
        state = transition.to();
        behaviour = behaviours.get(state);
        outgoing = OUTGOING.get(state);
        condition = transition.condition();
        sinceTick = estimate.tick();
        transitions++;
        entryHeading = odometer.heading();
        behaviour.enter(transition.from());
    }

    private static Map<FollowerState, List<Transition>> outgoing() {
        Map<FollowerState, List<Transition>> outgoing = new EnumMap<>(FollowerState.class);
        for (Transition transition : TRANSITIONS) {
            outgoing.computeIfAbsent(transition.from(), from -> new ArrayList<>())
                    .add(transition);
        }
        return outgoing;
    }

    private boolean turnedAllRound() {
        return Math.abs(odometer.heading() - entryHeading) > spec.thresholds().radians(Threshold.GIVE_UP_ANGLE);
    }

    private Telemetry telemetry(Telemetry.Diagnosis diagnosis) {
        EdgeTimer timing = alignment.edgeTimer();
        return new Telemetry(
                state,
                condition,
                sinceTick,
                transitions,
                new Telemetry.WallControl(
                        spec.distance(), estimate.left().reading(), wall.proportional(), wall.derivative()),
                new Telemetry.EdgeTimes(timing.tF3(), timing.tF4(), timing.tP(), alignment.clockOrigin()),
                diagnosis);
    }
}
