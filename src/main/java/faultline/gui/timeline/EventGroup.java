package faultline.gui.timeline;

import faultline.engine.recording.RunEvent;

/** The groups of events that the event log can hide. */
public enum EventGroup {
    /** The states of the controller, and when it timed the wall. */
    STATES,
    /** Faults and their ends. */
    FAULTS,
    /** What the diagnosis found. */
    FINDINGS,
    /** Other commands, executed or refused. */
    COMMANDS,
    /** Contacts with obstacles. */
    COLLISIONS,
    /** Where the run differs from the reference run, and the contact of that run. */
    GHOST,
    /** What controller programs have printed. */
    OUTPUT;

    /** Returns the group of an event. */
    public static EventGroup of(RunEvent event) {
        return switch (EventKind.of(event)) {
            case TRANSITION, TIMING -> STATES;
            case FAULT, REPAIR -> FAULTS;
            case TRUST, DISTRUST, RUNG -> FINDINGS;
            case COMMAND, REFUSAL -> COMMANDS;
            case COLLISION -> COLLISIONS;
            case DIVERGENCE, GHOST_COLLISION -> GHOST;
            case OUTPUT -> OUTPUT;
        };
    }
}
