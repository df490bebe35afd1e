package faultline.engine;

import faultline.engine.record.EventLog;
import faultline.engine.record.Hashes;
import faultline.engine.record.StateTally;
import faultline.engine.record.Trace;

/**
 * What is remembered of a run up to one moment. Immutable; taking one copies next to nothing.
 *
 * @param trace the numbers, tick by tick; channels as {@link faultline.engine.record.Channels} says
 * @param events what happened
 * @param states how long the controller was in which state
 * @param keyframes pictures of earlier moments
 * @param hashes of the trajectory, tick by tick
 */
public record Recording(Trace trace, EventLog events, StateTally states, Keyframes keyframes, Hashes hashes) {

    /** Of a run that is not recorded. */
    public static final Recording EMPTY = new Recording(Trace.EMPTY, EventLog.EMPTY, StateTally.EMPTY, Keyframes.EMPTY,
            Hashes.EMPTY);
}
