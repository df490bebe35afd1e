package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.engine.record.EventLog;
import faultline.engine.record.RunEvent;
import java.util.ArrayList;
import java.util.List;

/** The states of the controller one after another, as far as the event log still has them. */
final class StateRibbon {

    /**
     * A stay in a state.
     *
     * @param state its name
     * @param from its beginning, seconds
     * @param to its end, seconds
     */
    record Stay(String state, double from, double to) {
    }

    private StateRibbon() {
    }

    /** The stays that reach into a span, in order. */
    static List<Stay> stays(Frame frame, TimeSpan span) {
        List<Stay> stays = new ArrayList<>();
        String state = frame.control().state();
        double end = frame.world().time();
        EventLog log = frame.recording().events();
        for (long i = log.end() - 1; i >= log.first() && end > span.from(); i--) {
            if (log.get(i) instanceof RunEvent.Transition transition && transition.time() <= end) {
                stays.add(0, new Stay(state, transition.time(), end));
                state = transition.from();
                end = transition.time();
            }
        }
        if (log.first() == 0 && end > span.from()) {
            stays.add(0, new Stay(state, 0, end));
        }
        stays.removeIf(stay -> stay.from() > span.to());
        return stays;
    }
}
