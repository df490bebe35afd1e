package faultline.gui.window;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.Notes;
import faultline.gui.action.UiAction;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.CommandResult;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class EditNotifierTest {

    private final List<String> shown = new ArrayList<>();
    private final Workspace workspace = callOnEdt(Workspace::new);
    private final RunController run = callOnEdt(() -> new RunController(workspace));
    private EditNotifier notifier;

    @BeforeEach
    void openAtStart() {
        ActionRegistry actions = new ActionRegistry();
        runOnEdt(() -> {
            actions.add(UiAction.of("restart", () -> {}).withAccelerator(Keystrokes.unmodified(KeyEvent.VK_F5)));
            notifier =
                    new EditNotifier(workspace, actions, new Notes(shown::add, text -> {}, text -> {}, shown::remove));
            new DocumentStore(workspace).openShipped("yard.xml");
        });
        SessionFrames.awaitScenario(workspace);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    @Test
    void theNoteAboutAFailedRunGoesWhenTheRunIsMoved() {
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 1);
        runOnEdt(notifier::failedRunResumed);
        assertEquals(List.of("The run has failed; restart it with F5, or move it to an earlier time"), shown);
        runOnEdt(() -> notifier.runRepositioned(0, null, false));
        assertEquals(List.of(), shown);
    }

    @Test
    void theNoteAboutAFailedRunGoesWhenTheScenarioIsRestarted() {
        runOnEdt(() -> {
            workspace.addListener(notifier);
            notifier.failedRunResumed();
        });
        assertEquals(1, shown.size());
        runOnEdt(run::restart);
        Await.until("the note is gone", shown::isEmpty);
    }

    @Test
    void aRunThatHasFailedAtItsStartCannotBeMovedToAnEarlierTime() {
        runOnEdt(notifier::failedRunResumed);
        assertEquals(List.of("The run has failed at its start; restart it with F5"), shown);
    }

    private static CommandResult executed(Command command, Command... before) {
        List<Command> inverse = new ArrayList<>(List.of(new Command.ClearFaults("left")));
        inverse.addAll(List.of(before));
        return new CommandResult.Executed(1, command, inverse);
    }

    @Test
    void aFaultThatIsAddedToAnEqualOneIsNoted() {
        Command bias = new Command.InjectFault("left", new Fault.Bias(0.1));
        Command stuck = new Command.InjectFault("left", new Fault.Stuck(0.4));
        Command off = new Command.SwitchSensor("left", false);
        runOnEdt(() -> {
            notifier.editMade(List.of(executed(bias), executed(bias, stuck), executed(off, off)));
            assertEquals(List.of(), shown);
            notifier.editMade(List.of(executed(bias, stuck, bias)));
        });
        assertEquals(
                List.of("\"left: bias 0.10 m\" was active already; each of the equal faults has its own end"), shown);
    }
}
