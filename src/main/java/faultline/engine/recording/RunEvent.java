package faultline.engine.recording;

import faultline.control.ControllerState;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Refusal;
import java.util.function.Function;

/**
 * An event of a run. Code that depends on the kind of event gives {@link EventCases}, so that a new kind does not
 * compile until it is handled everywhere.
 */
public sealed interface RunEvent {

    /** {@return the tick at whose end the event becomes visible} */
    long tick();

    /** {@return the time of the event, seconds} */
    double time();

    /**
     * {@return the result of the function for this kind of event}
     *
     * @param <R> the type of the result
     * @param cases a function for each kind
     */
    <R> R match(EventCases<R> cases);

    /**
     * A function for each kind of event.
     *
     * @param <R> the type of the results
     * @param stateChanged for a new state
     * @param alignmentTimed for times of the wall
     * @param healthChanged for a finding about a sensor
     * @param rungChanged for another strategy
     * @param commandExecuted for a command
     * @param commandRefused for a refused command
     * @param collided for the first contact
     * @param diverged for the first difference from the reference run
     * @param ghostCollided for the first contact of the reference run
     * @param printed for a line that a controller program has printed
     */
    record EventCases<R>(
            Function<StateChanged, R> stateChanged,
            Function<AlignmentTimed, R> alignmentTimed,
            Function<HealthChanged, R> healthChanged,
            Function<RungChanged, R> rungChanged,
            Function<CommandExecuted, R> commandExecuted,
            Function<CommandRefused, R> commandRefused,
            Function<Collided, R> collided,
            Function<Diverged, R> diverged,
            Function<GhostCollided, R> ghostCollided,
            Function<Printed, R> printed) {}

    /**
     * The controller changed its state.
     *
     * @param tick the first tick in the new state
     * @param time the time of that tick, seconds
     * @param from the old state
     * @param to the new state
     * @param condition the condition of the transition
     */
    record StateChanged(long tick, double time, ControllerState from, ControllerState to, String condition)
            implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.stateChanged.apply(this);
        }
    }

    /**
     * The controller has timed the wall during an alignment turn.
     *
     * @param tick the tick in which the timing is complete
     * @param time the simulated time of that tick, seconds
     * @param edges the times on the clock of the spin, whose origin is known
     * @param rule the rule that determined F3 and F4
     */
    record AlignmentTimed(long tick, double time, Telemetry.EdgeTimes edges, TimingRule rule) implements RunEvent {

        /** {@return the simulated time of frame F3, seconds} */
        public double f3() {
            return edges.origin() + edges.tF3();
        }

        /** {@return the simulated time of frame F4, seconds} */
        public double f4() {
            return edges.origin() + edges.tF4();
        }

        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.alignmentTimed.apply(this);
        }
    }

    /**
     * The controller's diagnosis trusts a sensor more or less than before.
     *
     * @param tick the first tick in which the controller uses it
     * @param time the time of that tick, seconds
     * @param from the trust before
     * @param health the finding about the sensor now
     */
    record HealthChanged(long tick, double time, SensorTrust from, SensorHealth health) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.healthChanged.apply(this);
        }
    }

    /**
     * The rung of the controller's ladder of strategies that drives has changed.
     *
     * @param tick the first in which it drives
     * @param time the time of that tick, seconds
     * @param from the name of the rung before
     * @param to the name of the rung that drives now
     */
    record RungChanged(long tick, double time, String from, String to) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.rungChanged.apply(this);
        }
    }

    /**
     * A command of the timeline or from outside was executed.
     *
     * @param tick the tick at whose start it was executed
     * @param time the time of that tick, seconds
     * @param command the command
     */
    record CommandExecuted(long tick, double time, Command command) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.commandExecuted.apply(this);
        }
    }

    /**
     * A command was refused.
     *
     * @param tick the tick at whose start it was refused
     * @param time the time of that tick, seconds
     * @param command the command
     * @param refusal the reason
     */
    record CommandRefused(long tick, double time, Command command, Refusal refusal) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.commandRefused.apply(this);
        }
    }

    /**
     * The robot touched an obstacle for the first time.
     *
     * @param tick the tick of the contact
     * @param collision the contact
     */
    record Collided(long tick, Collision collision) implements RunEvent {
        @Override
        public double time() {
            return collision.time();
        }

        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.collided.apply(this);
        }
    }

    /**
     * The run differs from the reference run for the first time.
     *
     * @param tick the first tick in which they differ by at least a bit
     * @param time the time of that tick, seconds
     */
    record Diverged(long tick, double time) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.diverged.apply(this);
        }
    }

    /**
     * The robot of the reference run touched an obstacle for the first time. No run records it.
     *
     * @param tick the tick of the contact
     * @param collision the contact
     */
    record GhostCollided(long tick, Collision collision) implements RunEvent {
        @Override
        public double time() {
            return collision.time();
        }

        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.ghostCollided.apply(this);
        }
    }

    /**
     * A controller program has printed a line. When it arrives depends on the machine, so no run records it.
     *
     * @param tick the tick that was shown when the line was added
     * @param time the time of that tick, seconds
     * @param line the line
     */
    record Printed(long tick, double time, String line) implements RunEvent {
        @Override
        public <R> R match(EventCases<R> cases) {
            return cases.printed.apply(this);
        }
    }
}
