package faultline.gui.edit;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.Rename;
import faultline.gui.change.TimelineEvents;
import faultline.gui.document.RunController;
import faultline.scenario.Scenario;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * An edit of events, such as faults, that have become commands of the timeline, where they are undone and redone.
 *
 * @param edit the edit as it was made during the run
 * @param events what was executed when the edit was done, undone and redone
 * @param run changes the scenario
 */
record EventEdit(CommandEdit edit, List<TimedCommand> events, RunController run) implements Edit {

    EventEdit {
        events = List.copyOf(events);
    }

    @Override
    public String name() {
        return edit.name();
    }

    /** Returns whether the timeline has an event of the edit: it lacks those of one tick that cancelled each other. */
    @Override
    public boolean isEffective() {
        return !run.haveSameEffect(this::removedFrom, UnaryOperator.identity());
    }

    /** Returns this edit with another id of a sensor. */
    EventEdit renamed(Rename rename) {
        edit.rename(rename);
        return new EventEdit(
                edit,
                events.stream()
                        .map(event -> new TimedCommand(event.time(), rename.rename(event.command())))
                        .toList(),
                run);
    }

    /** Returns this edit with more events. */
    EventEdit with(List<TimedCommand> more) {
        List<TimedCommand> all = new ArrayList<>(events);
        all.addAll(more);
        return new EventEdit(edit, all, run);
    }

    /** Returns this edit with more events, which were executed in the present run. */
    EventEdit withExecuted(List<CommandResult> executed) {
        return with(executed.stream()
                .map(result -> new TimedCommand(run.timeOf(result.tick()), result.command()))
                .toList());
    }

    private Scenario removedFrom(Scenario scenario) {
        return TimelineEvents.without(scenario, events);
    }

    @Override
    public void apply(UndoController controller, boolean redone) {
        run.change(redone ? now -> TimelineEvents.with(now, events) : this::removedFrom);
    }
}
