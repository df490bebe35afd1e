package faultline.gui.instrument;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
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

/**
 * The newest alignment manoeuvre of a run. Times are those of the manoeuvre's clock: the angle turned since TURN began,
 * divided by the constant turn rate.
 *
 * @param samples the left reading during the turn, up to frame F4
 * @param start the heading at the beginning of TURN, radians
 * @param rate the turn rate, radians per second; negative for a turn to the right
 * @param headingNow the current heading, or the one at the end of ALIGN, radians
 * @param f3 when the left sensor met the wall, seconds; NaN if not yet known
 * @param f4 when the left sensor lost the wall, seconds; NaN if not yet known
 * @param tP the duration of the turn back, seconds; NaN if not yet known
 * @param origin the simulated time at which the manoeuvre's clock would be 0 at the constant turn rate, seconds
 * @param achievedHeading the heading at the end of ALIGN, radians; NaN if not yet known
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
        double achievedHeading) {

    /**
     * A reading.
     *
     * @param clock the time, seconds
     * @param reading the distance, metres; infinite if nothing is in range
     */
    record AlignmentSample(double clock, double reading) {}

    AlignmentTrace {
        samples = List.copyOf(samples);
    }

    /** The first ticks of the phases; for a phase that has not begun, the tick after the newest. */
    private record PhaseTicks(long turn, long align, long follow, boolean done) {

        static Optional<PhaseTicks> of(EventLog log, long end) {
            long align = end;
            long follow = end;
            for (long i = log.endIndex() - 1; i >= log.firstIndex(); i--) {
                if (log.get(i) instanceof RunEvent.StateChanged transition) {
                    if (leadsTo(transition, FollowerState.TURN)) {
                        return Optional.of(
                                new PhaseTicks(transition.tick(), Math.min(align, follow), follow, follow < end));
                    }
                    align = leadsTo(transition, FollowerState.ALIGN) ? transition.tick() : align;
                    follow = leadsTo(transition, FollowerState.FOLLOW) && transition.from() == FollowerState.ALIGN
                            ? transition.tick()
                            : follow;
                }
            }
            return Optional.empty();
        }

        private static boolean leadsTo(RunEvent.StateChanged transition, FollowerState state) {
            return transition.to() == state;
        }
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
        double rate = Math.copySign(frame.snapshot().robot().turnRate(), turnedBy == 0 ? -1 : turnedBy);
        List<AlignmentSample> samples = new ArrayList<>();
        // The reading that the controller reports in a tick was taken at the end of the tick before.
        for (long tick = ticks.turn(); tick < ticks.align(); tick++) {
            samples.add(new AlignmentSample(
                    (headingAt(level, tick - 1) - start) / rate, level.min(TraceChannels.MEASURED_DISTANCE, tick)));
        }
        double origin = (ticks.align() - 1) * dt(frame) - Math.abs(turnedBy / rate);
        Telemetry.EdgeTimes shown = edges(frame, ticks, origin);
        double now = headingAt(level, ticks.follow() - 1);
        return new AlignmentTrace(
                samples,
                start,
                rate,
                now,
                shown.tF3(),
                shown.tF4(),
                shown.tP(),
                origin,
                ticks.done() ? now : Double.NaN);
    }

    /**
     * Returns the controller's times; those of the event log if the controller no longer reports them, because another
     * strategy drives since the turn.
     */
    private static Telemetry.EdgeTimes edges(SessionFrame frame, PhaseTicks ticks, double origin) {
        Telemetry.EdgeTimes reported = frame.telemetry().edges();
        if (!Double.isNaN(reported.tP())) {
            return reported;
        }
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= log.firstIndex() && log.get(i).tick() >= ticks.align(); i--) {
            if (log.get(i) instanceof RunEvent.AlignmentTimed timed) {
                return new Telemetry.EdgeTimes(timed.f3() - origin, timed.f4() - origin, timed.tP());
            }
        }
        return reported;
    }

    private static double dt(SessionFrame frame) {
        return frame.snapshot().time() / Math.max(1, frame.snapshot().tick());
    }

    private static double headingAt(TraceLevel level, long tick) {
        return level.min(TraceChannels.HEADING, tick);
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
