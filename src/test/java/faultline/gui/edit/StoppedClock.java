package faultline.gui.edit;

import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/** Creates undo controllers for which no time passes, so that repeated edits form one however slow the machine is. */
public final class StoppedClock {

    private StoppedClock() {}

    /** Returns a controller without edits that sends commands through a channel. */
    public static UndoController undoController(BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel) {
        return undoController(channel, () -> {});
    }

    /** Returns such a controller that runs an action when its edits change. */
    static UndoController undoController(
            BiConsumer<List<Command>, Consumer<List<CommandResult>>> channel, Runnable onStateChange) {
        return new UndoController(channel, onStateChange, () -> 0);
    }
}
