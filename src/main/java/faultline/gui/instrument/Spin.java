package faultline.gui.instrument;

import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.record.Channels;
import faultline.engine.record.EventLog;
import faultline.engine.record.Level;
import faultline.engine.record.RunEvent;
import faultline.geometry.Angles;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The newest t_D/2 manoeuvre of a run, as its recording and telemetry have it. Times are the spin clock's: what the robot has turned from
 * where TURN began, at the constant rate.
 *
 * @param samples the left reading over the spin, up to frame F4
 * @param start the heading in which TURN began, radians
 * @param rate how the heading changes while the clock goes on, radians per second; negative for a spin to the right
 * @param now the heading by now, or in which ALIGN handed over, radians
 * @param f3 when the left sensor came to the wall, seconds, not a number before it is known
 * @param f4 when it left it, seconds, not a number before it is known
 * @param tP how long to turn back, seconds, not a number before it is known
 * @param achieved the heading in which ALIGN handed over, radians
 */
record Spin(List<Sample> samples, double start, double rate, double now, double f3, double f4, double tP, OptionalDouble achieved) {

    /**
     * A reading.
     *
     * @param clock seconds
     * @param reading metres; infinite for nothing
     */
    record Sample(double clock, double reading) {
    }

    Spin {
        samples = List.copyOf(samples);
    }

    /** The ticks of a manoeuvre; one that has not come yet is the tick after the newest. */
    private record Ticks(long turn, long align, long follow, boolean done) {

        static Optional<Ticks> of(EventLog log, long end) {
            long align = end;
            long follow = end;
            for (long i = log.end() - 1; i >= log.first(); i--) {
                if (log.get(i) instanceof RunEvent.Transition transition) {
                    if (leads(transition, FollowerState.TURN)) {
                        return Optional.of(new Ticks(transition.tick(), Math.min(align, follow), follow, follow < end));
                    }
                    align = leads(transition, FollowerState.ALIGN) ? transition.tick() : align;
                    follow = leads(transition, FollowerState.FOLLOW) && transition.from().equals(FollowerState.ALIGN.name())
                            ? transition.tick() : follow;
                }
            }
            return Optional.empty();
        }

        private static boolean leads(RunEvent.Transition transition, FollowerState state) {
            return transition.to().equals(state.name());
        }
    }

    /** The newest manoeuvre; empty before the first, and when it is so long ago that its single ticks are no longer recorded. */
    static Optional<Spin> latest(Frame frame) {
        Level level = frame.recording().trace().finest();
        return Ticks.of(frame.recording().events(), level.end()).filter(ticks -> ticks.turn() - 1 >= level.first())
                .map(ticks -> of(frame, level, ticks));
    }

    private static Spin of(Frame frame, Level level, Ticks ticks) {
        double start = heading(level, ticks.turn() - 1);
        double turnedBy = heading(level, ticks.align() - 1) - start;
        double rate = Math.copySign(frame.world().robot().turnRate(), turnedBy == 0 ? -1 : turnedBy);
        List<Sample> samples = new ArrayList<>();
        // The reading that the controller shows in a tick was taken at the end of the one before.
        for (long tick = ticks.turn(); tick < ticks.align(); tick++) {
            samples.add(new Sample((heading(level, tick - 1) - start) / rate, level.low(Channels.MEASURED, tick)));
        }
        Telemetry shown = frame.control();
        double now = heading(level, ticks.follow() - 1);
        return new Spin(samples, start, rate, now, shown.tF3(), shown.tF4(), shown.tP(), ticks.done() ? OptionalDouble.of(now)
                : OptionalDouble.empty());
    }

    private static double heading(Level level, long tick) {
        return level.low(Channels.HEADING, tick);
    }

    /** Whether F3 and F4 are known. */
    boolean isTimed() {
        return !Double.isNaN(tP);
    }

    double tD() {
        return f4 - f3;
    }

    /** The heading at a moment of the spin clock, radians. */
    double heading(double clock) {
        return start + rate * clock;
    }

    /** The moment of the spin clock at which the heading was so. */
    double clock(double heading) {
        return (heading - start) / rate;
    }

    /** The heading parallel to the wall by eq. (4), radians: turned back from F4 for t_p. */
    double predicted() {
        return heading(f4 - tP);
    }

    /** How far the achieved heading is to the left of the predicted one, radians. */
    OptionalDouble error() {
        return achieved.isPresent() && isTimed() ? OptionalDouble.of(Angles.normalize(achieved.getAsDouble() - predicted())) : OptionalDouble.empty();
    }
}
