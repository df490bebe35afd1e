package faultline.engine;

import faultline.world.Command;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/**
 * An interactive run: owns the world thread and the controller's, takes commands and orders from any thread without ever blocking the caller, and
 * publishes frames. It starts paused at tick 0. A restart is a new session from the same setup.
 */
public final class Session implements AutoCloseable {

    private Session() {
    }

    /**
     * Starts a session, paused at tick 0.
     *
     * @param setup what to run
     * @return the session, its first frame published
     */
    public static Session start(Setup setup) {
        throw new UnsupportedOperationException();
    }

    /**
     * The newest frame; asking also orders the next one, so that none is built when nobody looks. Wait-free.
     *
     * @return the frame
     */
    public Frame frame() {
        throw new UnsupportedOperationException();
    }

    /**
     * Gives a command, which is applied and journaled at the start of the next tick; while paused, its effect shows in the next frame at once.
     *
     * @param command what is to be done
     */
    public void send(Command command) {
        throw new UnsupportedOperationException();
    }

    /** Lets time run. */
    public void run() {
    }

    /** Holds time. */
    public void pause() {
    }

    /** Makes one tick and holds. */
    public void step() {
    }

    /**
     * Sets the pace.
     *
     * @param factor times real time, positive; positive infinity for as fast as possible
     */
    public void setSpeed(double factor) {
    }

    /**
     * How the session is.
     *
     * @return a value of this moment
     */
    public Status status() {
        throw new UnsupportedOperationException();
    }

    /**
     * What was done so far, taken between two ticks.
     *
     * @return completed on the world thread, soon
     */
    public CompletableFuture<Journal> journal() {
        throw new UnsupportedOperationException();
    }

    /** Ends the session and its threads; frames already taken stay good. */
    @Override
    public void close() {
    }

    /**
     * How a session is at one moment.
     *
     * @param running whether time runs
     * @param speed the pace asked for, times real time, positive infinity for as fast as possible
     * @param achieved the pace reached over the last half second, times real time; 0 while held
     * @param refusals how many commands were refused so far
     * @param lastRefusal why the last of them was
     * @param failure why the run broke off, empty while it is sound
     */
    public record Status(boolean running, double speed, double achieved, int refusals, Optional<String> lastRefusal,
            Optional<String> failure) {
    }
}
