package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;
import faultline.gui.theme.Glyph;

/** The shapes that tell the kinds of events apart without reading and without colour. */
public final class EventMark {

    private EventMark() {}

    /** Returns the shape for an event. */
    public static Glyph of(RunEvent event) {
        if (event instanceof RunEvent.CommandExecuted done) {
            return EventText.isFailure(event)
                    ? Glyph.FAULT
                    : CommandRole.isFaultChange(done.command()) ? Glyph.CHECK : Glyph.PENCIL;
        }
        if (event instanceof RunEvent.StateChanged) {
            return Glyph.TRANSITION;
        }
        if (event instanceof RunEvent.RungChanged) {
            return Glyph.STAIRS;
        }
        if (event instanceof RunEvent.HealthChanged) {
            return Glyph.PULSE;
        }
        if (event instanceof RunEvent.AlignmentTimed) {
            return Glyph.CLOCK;
        }
        if (event instanceof RunEvent.CommandRefused) {
            return Glyph.REMOVE;
        }
        return event instanceof RunEvent.Collided ? Glyph.COLLISION : Glyph.FORK;
    }
}
