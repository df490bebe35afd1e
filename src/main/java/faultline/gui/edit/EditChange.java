package faultline.gui.edit;

import faultline.gui.change.Rename;
import faultline.world.CommandResult;
import java.util.List;

/**
 * An edit that was done or undone at the start of a tick, and the results of the commands that redid or undid it; none
 * if it was done for the first time.
 */
record EditChange(long tick, CommandEdit edit, boolean done, List<CommandResult> results) {
    boolean isFirst() {
        return done && results.isEmpty();
    }

    /** Returns what was executed; the commands of a gesture may have been executed at several ticks. */
    List<CommandResult> executed() {
        return isFirst()
                ? edit.results()
                : results.stream().filter(result -> result.refusal().isEmpty()).toList();
    }

    EditChange with(List<CommandResult> newResults) {
        return new EditChange(tick, edit, done, newResults);
    }

    EditChange renamed(Rename rename) {
        return with(results.stream().map(rename::rename).toList());
    }
}
