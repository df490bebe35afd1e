package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.CpuTime;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EventIndexTest {

    private static final Command FAULT = new Command.InjectFault("front", new Fault.Bias(0.1));
    private static final Command CLEAR = new Command.ClearFaults("front");

    private static ExecutedChange change(CommandResult executed, Command... presentInverse) {
        return new ExecutedChange(executed.tick(), executed, executed)
                .withChange(new CommandResult.Executed(executed.tick(), executed.command(), List.of(presentInverse)));
    }

    private static CommandResult executed(long tick, Command... inverse) {
        return new CommandResult.Executed(tick, FAULT, List.of(inverse));
    }

    @Test
    void equalEventsOfOneTickAreDistinguishedByWhatUndoesThem() {
        List<CommandResult> executed =
                List.of(executed(1, CLEAR), executed(1, CLEAR, FAULT), executed(1, CLEAR, CLEAR), executed(2, CLEAR));
        List<ExecutedChange> changes = new ArrayList<>();
        executed.forEach(result ->
                changes.add(change(result, FAULT, new Command.SwitchSensor("number " + changes.size(), true))));
        EventIndex index = new EventIndex(changes);
        for (int i = 0; i < executed.size(); i++) {
            assertSame(changes.get(i).change(), index.present(executed.get(i)));
        }
        CommandResult unknown = executed(2, FAULT);
        assertSame(unknown, index.present(unknown));
    }

    @Test
    void manyEventsAreFoundInTimeInProportionToTheirNumber() {
        List<ExecutedChange> changes = new ArrayList<>();
        for (int i = 0; i < 100_000; i++) {
            changes.add(change(executed(i, CLEAR), CLEAR, FAULT));
        }
        CpuTime time = CpuTime.start();
        EventIndex index = new EventIndex(changes);
        for (ExecutedChange change : changes) {
            assertEquals(change.change(), index.present(change.executed()));
        }
        time.assertBelow(2);
    }
}
