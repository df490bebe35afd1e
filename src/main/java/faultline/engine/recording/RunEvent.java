package faultline.engine.recording;

import faultline.control.ControllerState;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Refusal;

/** Something that happened in a run at one moment. */
public sealed interface RunEvent {

    /**
     * The tick at whose end it shows.
     *
     * @return from 0
     */
    long tick();

    /**
     * When it happened.
     *
     * @return seconds
     */
    double time();

    /**
     * The controller came to another state.
     *
     * @param tick the first in which it acted by it
     * @param time of that tick, seconds
     * @param from the state that it left
     * @param to the state that it came to
     * @param condition the named condition of the arrow
     */
    record StateChanged(long tick, double time, ControllerState from, ControllerState to, String condition)
            implements RunEvent {}

    /**
     * The controller has timed the wall during an alignment turn.
     *
     * @param tick the tick in which the timing is complete
     * @param time the simulated time of that tick, seconds
     * @param f3 the simulated time of frame F3, seconds
     * @param f4 the simulated time of frame F4, seconds
     * @param tP the duration of the turn back, t_p of eq. (4), seconds
     */
    record AlignmentTimed(long tick, double time, double f3, double f4, double tP) implements RunEvent {}

    /**
     * The controller's diagnosis trusts a sensor more or less than before.
     *
     * @param tick the first in which the controller acted by it
     * @param time of that tick, seconds
     * @param from how far it was trusted before
     * @param health what the diagnosis thinks of the sensor now
     */
    record HealthChanged(long tick, double time, SensorTrust from, SensorHealth health) implements RunEvent {}

    /**
     * Another rung of the controller's ladder of strategies drives.
     *
     * @param tick the first in which it drives
     * @param time of that tick, seconds
     * @param from the name of the rung before
     * @param to the name of the rung that drives now
     */
    record RungChanged(long tick, double time, String from, String to) implements RunEvent {}

    /**
     * A command was carried out: one of the timeline, or one from outside.
     *
     * @param tick at whose start it was
     * @param time of that tick, seconds
     * @param command what was done
     */
    record CommandExecuted(long tick, double time, Command command) implements RunEvent {}

    /**
     * A command was refused.
     *
     * @param tick at whose start it was
     * @param time of that tick, seconds
     * @param command what was not done
     * @param refusal the reason
     */
    record CommandRefused(long tick, double time, Command command, Refusal refusal) implements RunEvent {}

    /**
     * The robot touched an obstacle for the first time.
     *
     * @param tick at whose end it showed
     * @param collision the contact
     */
    record Collided(long tick, Collision collision) implements RunEvent {
        @Override
        public double time() {
            return collision.time();
        }
    }

    /**
     * The run became another than the earlier one that it is compared with.
     *
     * @param tick the first in which they differ by a bit or more
     * @param time of that tick, seconds
     */
    record Diverged(long tick, double time) implements RunEvent {}
}
