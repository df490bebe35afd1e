package faultline.engine.session;

import faultline.io.Message;
import faultline.world.Refusal;
import java.util.Optional;

/**
 * The status of a session at one moment.
 *
 * @param running whether the run advances
 * @param speed the requested speed, multiple of real time; positive infinity for full speed
 * @param achievedSpeed the speed over the last half second, multiple of real time; 0 while paused
 * @param refusals the number of refused commands so far
 * @param lastRefusalOrNull the last refusal, null if there was none
 * @param failureOrNull why the run failed, null if it did not
 */
public record SessionStatus(
        boolean running,
        double speed,
        double achievedSpeed,
        int refusals,
        Refusal lastRefusalOrNull,
        Message failureOrNull) {

    /** {@return the last refusal, if there was one} */
    public Optional<Refusal> lastRefusal() {
        return Optional.ofNullable(lastRefusalOrNull);
    }

    /** {@return why the run failed, if it did} */
    public Optional<Message> failure() {
        return Optional.ofNullable(failureOrNull);
    }
}
