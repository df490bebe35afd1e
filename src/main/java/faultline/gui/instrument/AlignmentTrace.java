package faultline.gui.instrument;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.session.SessionFrame;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.recording.TraceChannels;
import faultline.engine.recording.TraceLevel;
import faultline.geometry.Angles;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The newest t_D/2 manoeuvre of a run, as its recording and telemetry have it. Times are the spin clock's: what the
 * robot has turned from where TURN began, at the constant rate.
 *
 * @param samples the left reading over the spin, up to frame F4
 * @param start the heading in which TURN began, radians
 * @param rate how the heading changes while the clock goes on, radians per second; negative for a spin to the right
 * @param headingNow the heading by now, or in which ALIGN handed over, radians
 * @param f3 when the left sensor came to the wall, seconds, not a number before it is known
 * @param f4 when it left it, seconds, not a number before it is known
 * @param tP how long to turn back, seconds, not a number before it is known
 * @param achievedHeading the heading in which ALIGN handed over, radians
 */
record AlignmentTrace(
        List<Sample> samples,
        double start,
        double rate,
        double headingNow,
        double f3,
        double f4,
        double tP,
        OptionalDouble achievedHeading) {

    /**
     * A reading.
     *
     * @param clock seconds
     * @param reading metres; infinite for nothing
     */
    record Sample(double clock, double reading) {}

    AlignmentTrace {
        samples = List.copyOf(samples);
    }

    /** The ticks of a manoeuvre; one that has not come yet is the tick after the newest. */
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
                    follow = leadsTo(transition, FollowerState.FOLLOW)
                                    && transition.from().equals(FollowerState.ALIGN.name())
                            ? transition.tick()
                            : follow;
                }
            }
            return Optional.empty();
        }

        private static boolean leadsTo(RunEvent.StateChanged transition, FollowerState state) {
            return transition.to().equals(state.name());
        }
    }

    /**
     * The newest manoeuvre; empty before the first, and when it is so long ago that its single ticks are no longer
     * recorded.
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
        List<Sample> samples = new ArrayList<>();
        // The reading that the controller shows in a tick was taken at the end of the one before.
        for (long tick = ticks.turn(); tick < ticks.align(); tick++) {
            samples.add(new Sample(
                    (headingAt(level, tick - 1) - start) / rate, level.min(TraceChannels.MEASURED_DISTANCE, tick)));
        }
        Telemetry shown = frame.telemetry();
        double now = headingAt(level, ticks.follow() - 1);
        return new AlignmentTrace(
                samples,
                start,
                rate,
                now,
                shown.tF3(),
                shown.tF4(),
                shown.tP(),
                ticks.done() ? OptionalDouble.of(now) : OptionalDouble.empty());
    }

    private static double headingAt(TraceLevel level, long tick) {
        return level.min(TraceChannels.HEADING, tick);
    }

    /** Whether F3 and F4 are known. */
    boolean isTimed() {
        return !Double.isNaN(tP);
    }

    double tD() {
        return f4 - f3;
    }

    /** The heading at a moment of the spin clock, radians. */
    double headingAt(double clock) {
        return start + rate * clock;
    }

    /** The moment of the spin clock at which the heading was so. */
    double clockAt(double heading) {
        return (heading - start) / rate;
    }

    /** The heading parallel to the wall by eq. (4), radians: turned back from F4 for t_p. */
    double predictedHeading() {
        return headingAt(f4 - tP);
    }

    /** How far the achieved heading is to the left of the predicted one, radians. */
    OptionalDouble headingError() {
        return achievedHeading.isPresent() && isTimed()
                ? OptionalDouble.of(Angles.normalize(achievedHeading.getAsDouble() - predictedHeading()))
                : OptionalDouble.empty();
    }
}
