package faultline.world;

import faultline.sensor.FaultSequence;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** The result of a command: executed with its inverse, or refused with the reason. */
public sealed interface CommandResult {

    /** {@return the tick at whose start the command was handled; 0 before the first sensing} */
    long tick();

    /** {@return the command} */
    Command command();

    /**
     * {@return the command as it has changed the world} This is another one only for an obstacle that was moved into
     * the robot: it stopped where they touch. A replay needs the command itself, because a move that ends where they
     * touch is no contact.
     */
    default Command effect() {
        return command();
    }

    /**
     * {@return the commands, in order, that restore what the command has changed; empty for a refused command} A
     * collision that it has caused is not undone. An obstacle that was removed comes back where it was, as if it were
     * placed for the first time: above the others, and if it moves, toward its first waypoint. A moving obstacle whose
     * waypoints were changed moves toward its first one, too.
     */
    List<Command> inverse();

    /** {@return the reason for a refusal; empty for an executed command} */
    Optional<Refusal> refusal();

    /** {@return whether the command was executed and has changed nothing, such as a switch to the present state} */
    default boolean isNoOp() {
        return inverse().equals(List.of(command()));
    }

    /**
     * {@return the commands that restore faults: one clears all, the others inject the former ones in their order} They
     * take no memory, because the sequence keeps them.
     *
     * @param clearAll the command that clears all
     * @param injections the commands that inject the former faults, oldest first
     */
    static List<Command> restoration(Command clearAll, FaultSequence<Command> injections) {
        return new CommandHandler.FaultRestoration<>(clearAll, injections, Function.identity());
    }

    /**
     * The command was executed.
     *
     * @param tick the tick at whose start it was executed
     * @param command the command
     * @param effect the command as it has changed the world
     * @param inverse the commands, in order, that undo it
     */
    record Executed(long tick, Command command, Command effect, List<Command> inverse) implements CommandResult {
        /**
         * Creates the result of a command that was executed.
         *
         * @param tick the tick at whose start it was executed
         * @param command the command
         * @param effect the command as it has changed the world
         * @param inverse the commands, in order, that undo it
         */
        public Executed {
            inverse = CommandHandler.FaultRestoration.immutable(inverse);
        }

        /**
         * Creates the result of a command that was executed as it is.
         *
         * @param tick the tick at whose start it was executed
         * @param command the command
         * @param inverse the commands, in order, that undo it
         */
        public Executed(long tick, Command command, List<Command> inverse) {
            this(tick, command, command, inverse);
        }

        @Override
        public Optional<Refusal> refusal() {
            return Optional.empty();
        }
    }

    /**
     * The command was refused and changed nothing.
     *
     * @param tick the tick at whose start it was refused
     * @param command the command
     * @param reason the reason
     */
    record Refused(long tick, Command command, Refusal reason) implements CommandResult {
        @Override
        public List<Command> inverse() {
            return List.of();
        }

        @Override
        public Optional<Refusal> refusal() {
            return Optional.of(reason);
        }
    }
}
