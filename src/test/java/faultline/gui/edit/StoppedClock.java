package faultline.gui.edit;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/** Creates command senders for which no time passes, so that repeated edits form one however slow the machine is. */
public final class StoppedClock {

    private StoppedClock() {}

    /** Returns a sender that sends commands through a channel. */
    public static CommandSender sender(BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel) {
        return sender(channel, () -> 0);
    }

    /** Returns a sender whose clock, in milliseconds, is moved by the test. */
    public static CommandSender sender(
            BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel, LongSupplier clock) {
        return new CommandSender(channel, clock);
    }
}
