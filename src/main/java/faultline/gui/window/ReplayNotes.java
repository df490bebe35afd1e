package faultline.gui.window;

import faultline.engine.Frame;
import faultline.gui.document.TimeTravel;
import faultline.gui.text.Texts;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.function.Consumer;

/** Tells the user that a saved run is open, and when its replay has come to its end. */
final class ReplayNotes {

    private final TimeTravel travel;
    private final Consumer<String> told;
    private boolean announced;
    private boolean ended;

    ReplayNotes(TimeTravel travel, Consumer<String> told) {
        this.travel = travel;
        this.told = told;
    }

    /** A session has begun. */
    void begun() {
        announced = false;
        ended = false;
    }

    /** Shows where the run is. */
    void show(Frame frame) {
        OptionalLong end = travel.replayEnd();
        if (end.isPresent()) {
            show(frame.world().tick(), end.getAsLong(), frame.world().time());
        }
    }

    private void show(long tick, long end, double time) {
        if (tick == end && !ended) {
            told.accept(Texts.text("replay.ended", String.format(Locale.ROOT, "%.2f", time)));
        } else if (tick == 0 && !announced) {
            told.accept(Texts.text("replay.begun"));
        }
        announced = true;
        ended = tick == end;
    }
}
