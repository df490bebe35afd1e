package faultline.engine.recording;

/**
 * What is remembered of a run up to one moment. Immutable; taking one copies next to nothing.
 *
 * @param trace the numbers, tick by tick; channels as {@link faultline.engine.recording.TraceChannels} says
 * @param events what happened
 * @param stateTally how long the controller was in which state
 * @param keyframes pictures of earlier moments
 * @param hashTrace of the trajectory, tick by tick
 */
public record Recording(Trace trace, EventLog events, StateTally stateTally, Keyframes keyframes, HashTrace hashTrace) {

    /** The recording of a run that is not recorded. */
    public static final Recording EMPTY =
            new Recording(Trace.EMPTY, EventLog.EMPTY, StateTally.EMPTY, Keyframes.EMPTY, HashTrace.EMPTY);
}
