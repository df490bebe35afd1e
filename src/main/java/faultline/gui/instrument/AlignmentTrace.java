package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.control.ladder.Rung;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.recording.TraceChannels;
import faultline.engine.recording.TraceLevel;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Angles;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The newest alignment manoeuvre of a run. Times are those of the manoeuvre's clock: the angle that the controller
 * takes the robot to have turned since TURN began, divided by the turn rate that it commands.
 *
 * @param samples the reading on the side of the wall during the turn, up to frame F4
 * @param start the heading at the beginning of TURN, radians
 * @param rate the angle that the robot turns in a second of the clock, radians; negative for a turn to the right
 * @param headingNow the current heading, or the one at the end of the manoeuvre, radians
 * @param f3 when the sensor on the side of the wall met it, seconds; NaN if not yet known
 * @param f4 when that sensor lost the wall, seconds; NaN if not yet known
 * @param tP the duration of the turn back, seconds; NaN if not yet known
 * @param origin the simulated time at which the manoeuvre's clock would be 0 at the constant turn rate, seconds; NaN if
 *     not yet known
 * @param achievedHeading the heading at the end of ALIGN, radians; NaN if not yet known
 * @param rule the rule that determined F3 and F4; the present one if they are not yet known
 */
record AlignmentTrace(
        List<AlignmentSample> samples,
        double start,
        double rate,
        double headingNow,
        double f3,
        double f4,
        double tP,
        double origin,
        double achievedHeading,
        TimingRule rule) {

    /** A time, seconds, and the distance, metres, that was read then; infinite if nothing is in range. */
    record AlignmentSample(double clock, double reading) {}

    AlignmentTrace {
        samples = List.copyOf(samples);
    }

    /**
     * The first ticks of the phases; for a phase that has not begun, the tick after the newest.
     *
     * @param turn the first tick of TURN
     * @param align the first tick of ALIGN, or the end of a manoeuvre that was interrupted before
     * @param end the first tick in another state, or with another strategy that uses the same names of states
     * @param done whether the manoeuvre led to FOLLOW
     */
    private record PhaseTicks(long turn, long align, long end, boolean done) {

        private static final Set<ControllerState> STATES =
                Set.of(FollowerState.TURN, FollowerState.MEASURE, FollowerState.ALIGN);

        static Optional<PhaseTicks> of(EventLog log, long newest) {
            long align = newest;
            long end = newest;
            boolean done = false;
            for (long i = log.endIndex() - 1; i >= log.firstIndex(); i--) {
                if (log.get(i) instanceof RunEvent.RungChanged change && !Rung.drivesSixStates(change.to())) {
                    end = change.tick();
                    done = false;
                } else if (log.get(i) instanceof RunEvent.StateChanged transition) {
                    if (transition.to() == FollowerState.TURN) {
                        return Optional.of(new PhaseTicks(transition.tick(), Math.min(align, end), end, done));
                    } else if (transition.to() == FollowerState.ALIGN) {
                        align = transition.tick();
                    } else if (!STATES.contains(transition.to())) {
                        end = transition.tick();
                        done = transition.from() == FollowerState.ALIGN && transition.to() == FollowerState.FOLLOW;
                    }
                }
            }
            return Optional.empty();
        }
    }

    /** Returns the side of the wall, from which the robot turns away. */
    WallSide wallSide() {
        return rate < 0 ? WallSide.LEFT : WallSide.RIGHT;
    }

    /**
     * Returns the newest manoeuvre; empty before the first one, and if its ticks are no longer recorded individually.
     */
    static Optional<AlignmentTrace> latest(SessionFrame frame) {
        TraceLevel level = frame.recording().trace().finestLevel();
        return PhaseTicks.of(frame.recording().events(), level.endBucket())
                .filter(ticks -> ticks.turn() - 1 >= level.firstBucket())
                .map(ticks -> of(frame, level, ticks));
    }

    private static AlignmentTrace of(SessionFrame frame, TraceLevel level, PhaseTicks ticks) {
        double start = headingAt(level, ticks.turn() - 1);
        double turnedBy = headingAt(level, ticks.align() - 1) - start;
        Telemetry.EdgeTimes shown = edges(frame, ticks);
        double rate = rate(frame, turnedBy, (ticks.align() - 1) * frame.dt() - shown.origin());
        List<AlignmentSample> samples = new ArrayList<>();
        // The reading that the controller reports in a tick was taken at the end of the tick before.
        for (long tick = ticks.turn(); tick < ticks.align(); tick++) {
            samples.add(new AlignmentSample(
                    (headingAt(level, tick - 1) - start) / rate, level.min(TraceChannels.MEASURED_DISTANCE, tick)));
        }
        double now = headingAt(level, ticks.end() - 1);
        return new AlignmentTrace(
                samples,
                start,
                rate,
                now,
                shown.tF3(),
                shown.tF4(),
                shown.tP(),
                shown.origin(),
                ticks.done() ? now : Double.NaN,
                timing(frame, ticks).map(RunEvent.AlignmentTimed::rule).orElse(presentRule(frame)));
    }

    /**
     * Returns how far the robot has turned in a second of the manoeuvre's clock, radians; the commanded rate if the
     * clock is not known. They differ if a motor is weak or the wheels are not as the controller takes them to be.
     *
     * @param turnedBy the angle by which the robot has turned, radians, counter-clockwise positive
     * @param clock the time of the clock after that, seconds; NaN if it is not known
     */
    private static double rate(SessionFrame frame, double turnedBy, double clock) {
        return turnedBy != 0 && Math.abs(clock) > frame.dt()
                ? turnedBy / clock
                : Math.copySign(frame.snapshot().robot().spinRate(), turnedBy == 0 ? -1 : turnedBy);
    }

    /** Returns the recorded timing of a manoeuvre. */
    private static Optional<RunEvent.AlignmentTimed> timing(SessionFrame frame, PhaseTicks ticks) {
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= log.firstIndex() && log.get(i).tick() >= ticks.align(); i--) {
            if (log.get(i) instanceof RunEvent.AlignmentTimed timed) {
                return Optional.of(timed);
            }
        }
        return Optional.empty();
    }

    /** Returns the rule of the present controller; the default rule if it is no wall follower. */
    static TimingRule presentRule(SessionFrame frame) {
        return frame.controller() instanceof ControllerSpec.WallFollowing follower
                ? follower.timingRule()
                : ControllerSpec.WallFollowing.DEFAULT.timingRule();
    }

    /**
     * Returns the controller's times; the recorded ones if the controller no longer reports them, because another
     * strategy drives since the turn.
     */
    private static Telemetry.EdgeTimes edges(SessionFrame frame, PhaseTicks ticks) {
        Telemetry.EdgeTimes reported = frame.telemetry().edges();
        return Double.isNaN(reported.tP())
                ? timing(frame, ticks).map(RunEvent.AlignmentTimed::edges).orElse(reported)
                : reported;
    }

    private static double headingAt(TraceLevel level, long tick) {
        return (double) level.min(TraceChannels.HEADING, tick) + level.min(TraceChannels.HEADING_REST, tick);
    }

    /** Returns whether F3 and F4 are known. */
    boolean isTimed() {
        return !Double.isNaN(tP);
    }

    double tD() {
        return f4 - f3;
    }

    /** Returns the heading at a time of the manoeuvre's clock, radians. */
    double headingAt(double clock) {
        return start + rate * clock;
    }

    /** Returns the time of the manoeuvre's clock at a heading, seconds. */
    double clockAt(double heading) {
        return (heading - start) / rate;
    }

    /** Returns the heading parallel to the wall by eq. (4), radians: that at F4, turned back for t_p. */
    double predictedHeading() {
        return headingAt(f4 - tP);
    }

    /**
     * Returns the angle from the predicted to the achieved heading, radians, counter-clockwise positive; empty if not
     * yet known.
     */
    OptionalDouble headingError() {
        return !Double.isNaN(achievedHeading) && isTimed()
                ? OptionalDouble.of(Angles.normalize(achievedHeading - predictedHeading()))
                : OptionalDouble.empty();
    }
}
