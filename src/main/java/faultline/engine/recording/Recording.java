package faultline.engine.recording;

/**
 * The recorded data of a run up to one moment. Immutable; creating one copies almost nothing.
 *
 * @param trace the numbers, tick by tick; {@link faultline.engine.recording.TraceChannels} defines the channels
 * @param events the events
 * @param stateTally the time that the controller spent in each state
 * @param keyframes frames of earlier moments
 * @param hashTrace the hashes of the trajectory, tick by tick
 */
public record Recording(Trace trace, EventLog events, StateTally stateTally, Keyframes keyframes, HashTrace hashTrace) {

    /** The recording of a run that is not recorded. */
    public static final Recording EMPTY =
            new Recording(Trace.EMPTY, EventLog.EMPTY, StateTally.EMPTY, Keyframes.EMPTY, HashTrace.EMPTY);
}
