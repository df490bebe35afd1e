package faultline.gui.instrument;

import faultline.control.ControllerState;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The sequence of controller states, as far as it is still in the event log. */
final class StateIntervals {

    /** An interval, seconds, during which the controller is in one state. */
    record StateInterval(ControllerState state, double start, double end) {}

    private StateIntervals() {}

    /** Returns the intervals that overlap a time span, in order. */
    static List<StateInterval> within(SessionFrame frame, TimeSpan span) {
        List<StateInterval> intervals = new ArrayList<>();
        ControllerState state = frame.telemetry().state();
        double end = frame.snapshot().time();
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= log.firstIndex() && end > span.start(); i--) {
            if (log.get(i) instanceof RunEvent.StateChanged transition && transition.time() <= end) {
                intervals.add(new StateInterval(state, transition.time(), end));
                state = transition.from();
                end = transition.time();
            }
        }
        if (log.firstIndex() == 0 && end > span.start()) {
            intervals.add(new StateInterval(state, 0, end));
        }
        Collections.reverse(intervals);
        intervals.removeIf(interval -> interval.start() > span.end());
        return intervals;
    }
}
