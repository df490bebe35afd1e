package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.world.Command;

/** The kinds of events that the event log tells apart, without reading and without colour by their marks. */
public enum EventKind {
    /** The controller changed its state. */
    TRANSITION("event.transition", Glyph.TRANSITION, false),
    /** The controller timed the wall. */
    TIMING("event.timing", Glyph.CLOCK, false),
    /** The diagnosis trusts a sensor again. */
    TRUST("event.health", Glyph.PULSE, false),
    /** The diagnosis does not trust a sensor. */
    DISTRUST("event.health", Glyph.PULSE, true),
    /** The rung of the ladder that drives has changed. */
    RUNG("event.rung", Glyph.STAIRS, false),
    /** A command added a fault. */
    FAULT("event.fault", Glyph.FAULT, true),
    /** A command removed faults. */
    REPAIR("event.fault", Glyph.CHECK, false),
    /** Another command was executed. */
    COMMAND("event.command", Glyph.PENCIL, false),
    /** A command was refused. */
    REFUSAL("event.refused", Glyph.REMOVE, true),
    /** The robot touched an obstacle. */
    COLLISION("event.collision", Glyph.COLLISION, true),
    /** The run differs from the reference run. */
    DIVERGENCE("event.ghost", Glyph.FORK, false),
    /** The robot of the reference run touched an obstacle. */
    GHOST_COLLISION("event.ghost", Glyph.COLLISION, false),
    /** A controller program has printed a line. */
    OUTPUT("event.output", Glyph.PROMPT, false);

    private final String key;
    private final Glyph mark;
    private final boolean warning;

    EventKind(String key, Glyph mark, boolean warning) {
        this.key = key;
        this.mark = mark;
        this.warning = warning;
    }

    public static EventKind of(RunEvent event) {
        return event.match(new RunEvent.EventCases<>(
                stateChanged -> TRANSITION,
                alignmentTimed -> TIMING,
                healthChanged -> healthChanged.health().isTrusted() ? TRUST : DISTRUST,
                rungChanged -> RUNG,
                commandExecuted -> ofExecuted(commandExecuted.command()),
                commandRefused -> REFUSAL,
                collided -> COLLISION,
                diverged -> DIVERGENCE,
                ghostCollided -> GHOST_COLLISION,
                printed -> OUTPUT));
    }

    /** Returns the name of the kind in the user's language. */
    public String text() {
        return Messages.get(key);
    }

    /** Returns the shape beside the name. */
    public Glyph mark() {
        return mark;
    }

    /** Returns whether the mark has the colour of warnings. */
    public boolean isWarning() {
        return warning;
    }

    private static EventKind ofExecuted(Command command) {
        CommandRole role = CommandRole.of(command);
        if (role.effect() != CommandRole.ChangedProperty.FAULT) {
            return COMMAND;
        }
        return role.isFaultStart() ? FAULT : REPAIR;
    }
}
