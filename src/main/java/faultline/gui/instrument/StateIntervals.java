package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import java.util.ArrayList;
import java.util.List;

/** The states of the controller one after another, as far as the event log still has them. */
final class StateIntervals {

    /**
     * A stay in a state.
     *
     * @param state its name
     * @param start its beginning, seconds
     * @param end its end, seconds
     */
    record StateInterval(String state, double start, double end) {}

    private StateIntervals() {}

    /** The stays that reach into a span, in order. */
    static List<StateInterval> within(SessionFrame frame, TimeSpan span) {
        List<StateInterval> stays = new ArrayList<>();
        String state = frame.telemetry().state();
        double end = frame.snapshot().time();
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= log.firstIndex() && end > span.start(); i--) {
            if (log.get(i) instanceof RunEvent.StateChanged transition && transition.time() <= end) {
                stays.add(0, new StateInterval(state, transition.time(), end));
                state = transition.from();
                end = transition.time();
            }
        }
        if (log.firstIndex() == 0 && end > span.start()) {
            stays.add(0, new StateInterval(state, 0, end));
        }
        stays.removeIf(stay -> stay.start() > span.end());
        return stays;
    }
}
